package org.selectiverenderer.radiosity.bake;

/**
 * Gives texels between charts the colour of the nearest texel of one, so that nothing foreign is
 * seen where a picture is drawn smaller.
 */
final class Gutters {
  private Gutters() {}

  /**
   * Fills what belongs to nothing.
   *
   * @param owners per texel: a number of at least 0, or -1 for none
   * @param colours r, g, b per texel; those of none are overwritten
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
