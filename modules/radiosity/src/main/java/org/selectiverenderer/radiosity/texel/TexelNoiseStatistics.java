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
public record TexelNoiseStatistics(double mean, double most, int places) {
  /** The statistics if nothing was gathered by rays. */
  public static final TexelNoiseStatistics NONE = new TexelNoiseStatistics(0, 0, 0);
}
