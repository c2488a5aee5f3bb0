package org.selectiverenderer.radiosity.texel;

import java.util.List;

/** Selects the texels that are gathered, and gives light to the others. */
public interface TexelSelection {
  /** Selects all texels. */
  TexelSelection ALL = (page, texel) -> true;

  boolean wanted(int page, int texel);

  /**
   * Gives light to the texels that are not selected, once all others have theirs.
   *
   * @param irradiance by page: r, g, b per texel; gutters are not filled yet
   */
  default void rest(List<float[]> irradiance) {
    // They stay dark.
  }
}
