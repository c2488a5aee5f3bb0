package org.selectiverenderer.radiosity.atlas;

import java.util.OptionalDouble;

/**
 * Settings of the lightmap atlas: texel density, budget and page size.
 *
 * @param texelsPerMetre texel density of surfaces as large as a room's; smaller bodies get up to
 *     three times as many texels per metre, since their shadows are smaller. Empty for the default,
 *     which is lowered evenly until the budget is kept
 * @param budgetBytes upper limit of the memory of all pages, at {@link #BYTES_PER_TEXEL}; the files
 *     are smaller
 * @param largestPage the longest side of a page, texels
 */
public record AtlasSettings(OptionalDouble texelsPerMetre, long budgetBytes, int largestPage) {
  /** Red, green and blue, before a file compresses them. */
  public static final int BYTES_PER_TEXEL = 3;

  /** The settings of the command without options. */
  public static final AtlasSettings DEFAULT =
      new AtlasSettings(OptionalDouble.empty(), 24L << 20, 2048);

  public AtlasSettings {
    texelsPerMetre.ifPresent(
        density ->
            require(
                density > 0 && density <= 1e6,
                "the texels per metre must be above 0 and at most 1e6"));
    require(budgetBytes >= 1024, "the texture budget must be at least 1024 bytes");
    require(
        largestPage >= 64 && largestPage <= 16_384,
        "the largest page must have from 64 to 16384 texels");
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
