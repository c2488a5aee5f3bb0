package org.selectiverenderer.radiosity.texel;

import java.util.List;

/** Which texels are gathered; the others have their light from elsewhere. */
public interface TexelChoice {
  /** All of them. */
  TexelChoice ALL = (page, texel) -> true;

  boolean wanted(int page, int texel);

  /**
   * Gives light to the texels that are not wanted, once all others have theirs.
   *
   * @param irradiance by page: r, g, b per texel; gutters are not filled yet
   */
  default void rest(List<float[]> irradiance) {
    // They stay dark.
  }
}
