package org.selectiverenderer.radiosity.texel;

/**
 * What noise the rays left in the light, as standard errors in shares of the light.
 *
 * @param mean over all places that gathered
 * @param most what 95 percent of them do not exceed
 * @param places at which light from surfaces was gathered
 */
public record TexelNoise(double mean, double most, int places) {
  /** Nothing was gathered by rays. */
  public static final TexelNoise NONE = new TexelNoise(0, 0, 0);
}
