package org.selectiverenderer.radiosity.atlas;

/**
 * One page of the atlas: the surface point that each of its texels shows. Rows go from the bottom
 * up, as texture coordinates do; texel (x, y) is number {@code y * width + x}, and its centre is at
 * s = (x + 0.5) / width, t = (y + 0.5) / height.
 *
 * <p>A texel belongs to a chart if its square touches the chart. Where the centre lies outside of
 * the chart, its surface point is the closest one of the chart, so that no point lies off the
 * surface. No texel belongs to two charts, and between charts there are texels of none: the
 * gutters.
 *
 * @param width texels
 * @param height texels
 * @param triangle per texel: the triangle of the scene, {@link #NONE} outside of all charts
 * @param u per texel: weight of the triangle's second corner
 * @param v per texel: weight of the triangle's third corner
 * @param chart per texel: a number that neighbouring texels of one chart share, {@link #NONE}
 *     outside
 */
public record AtlasPage(int width, int height, int[] triangle, float[] u, float[] v, int[] chart) {
  /** Marks a texel without triangle and chart. */
  public static final int NONE = -1;

  public int texels() {
    return width * height;
  }
}
