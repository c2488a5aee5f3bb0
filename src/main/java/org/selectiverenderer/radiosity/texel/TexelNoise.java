package org.selectiverenderer.radiosity.texel;

/**
 * Statistics of the Monte Carlo noise left in the light after denoising: standard errors as shares
 * of a texel's light. Where there is less than a hundredth of the scene's mean light, they are
 * shares of that hundredth.
 *
 * @param mean mean over all texels
 * @param most 95th percentile
 * @param places number of irradiance records
 */
public record TexelNoise(double mean, double most, int places) {
  /** The statistics if nothing was gathered by rays. */
  public static final TexelNoise NONE = new TexelNoise(0, 0, 0);
}
