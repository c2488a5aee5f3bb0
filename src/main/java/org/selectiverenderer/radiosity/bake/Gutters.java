package org.selectiverenderer.radiosity.bake;

/**
 * Dilates charts into the gutters between them: each gutter texel takes the colour of the nearest
 * texel of a chart, so that minification filters mix in no foreign colour.
 */
final class Gutters {
  private Gutters() {}

  /**
   * Fills the texels that belong to no body.
   *
   * @param owners per texel: the number of its body, 0 or above, or -1 for none
   * @param colours r, g, b per texel; those of gutters are overwritten
   */
  static void fill(int width, int height, int[] owners, float[] colours) {
    int[] queue = new int[owners.length];
    boolean[] filled = new boolean[owners.length];
    int end = 0;
    for (int texel = 0; texel < owners.length; texel++) {
      if (owners[texel] >= 0) {
        filled[texel] = true;
        queue[end++] = texel;
      }
    }
    for (int at = 0; at < end; at++) {
      int texel = queue[at];
      int x = texel % width;
      end = spread(texel, x > 0 ? texel - 1 : texel, colours, filled, queue, end);
      end = spread(texel, x < width - 1 ? texel + 1 : texel, colours, filled, queue, end);
      end = spread(texel, texel >= width ? texel - width : texel, colours, filled, queue, end);
      int above = texel + width;
      end = spread(texel, above < width * height ? above : texel, colours, filled, queue, end);
    }
  }

  private static int spread(
      int from, int to, float[] colours, boolean[] filled, int[] queue, int end) {
    if (filled[to]) {
      return end;
    }
    filled[to] = true;
    System.arraycopy(colours, 3 * from, colours, 3 * to, 3);
    queue[end] = to;
    return end + 1;
  }
}
