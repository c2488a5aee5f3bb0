package org.selectiverenderer.radiosity.texel;

/**
 * What noise the rays left in the light, as standard errors in shares of a texel's light: those
 * that are left when the noise of places around it was evened out. Where there is less than a
 * hundredth of the scene's mean light, they are shares of that hundredth.
 *
 * @param mean over all texels
 * @param most what 95 percent of them do not exceed
 * @param places at which light from surfaces was gathered
 */
public record TexelNoise(double mean, double most, int places) {
  /** Nothing was gathered by rays. */
  public static final TexelNoise NONE = new TexelNoise(0, 0, 0);
}
