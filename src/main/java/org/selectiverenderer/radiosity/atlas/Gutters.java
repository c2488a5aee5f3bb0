package org.selectiverenderer.radiosity.atlas;

import java.util.Arrays;

/**
 * Fills what lies between charts, so that no filter mixes anything else into them. Charts keep two
 * texels of distance: bilinear filtering meets only texels of its own chart, and so does the first
 * smaller level of a mipmap nearly everywhere; further levels mix charts.
 */
public final class Gutters {
  private Gutters() {}

  /**
   * Gives every texel of no chart the value of the nearest one of a chart, in steps to eight sides.
   *
   * @param rgb three numbers per texel; changed
   */
  public static void fill(TexelMap map, float[] rgb) {
    int[] nearest = nearest(map);
    for (int i = 0; i < nearest.length; i++) {
      if (nearest[i] != i && nearest[i] >= 0) {
        System.arraycopy(rgb, 3 * nearest[i], rgb, 3 * i, 3);
      }
    }
  }

  /**
   * Per texel the nearest one of a chart, itself if it is of one; NONE on a page without charts.
   */
  public static int[] nearest(TexelMap map) {
    int width = map.width();
    int[] nearest = new int[map.texels()];
    Arrays.fill(nearest, TexelMap.NONE);
    int[] queue = new int[map.texels()];
    int size = 0;
    for (int i = 0; i < nearest.length; i++) {
      if (map.chart()[i] != TexelMap.NONE) {
        nearest[i] = i;
        queue[size++] = i;
      }
    }
    for (int at = 0; at < size; at++) {
      int texel = queue[at];
      int x = texel % width;
      int y = texel / width;
      // Sides before corners, so that straight borders go on straight.
      for (int k = 0; k < 8; k++) {
        int nx = x + (k < 4 ? (k < 2 ? 2 * k - 1 : 0) : (k % 2 == 0 ? -1 : 1));
        int ny = y + (k < 4 ? (k < 2 ? 0 : 2 * k - 5) : (k < 6 ? -1 : 1));
        if (nx >= 0 && ny >= 0 && nx < width && ny < map.height()) {
          int next = ny * width + nx;
          if (nearest[next] < 0) {
            nearest[next] = nearest[texel];
            queue[size++] = next;
          }
        }
      }
    }
    return nearest;
  }
}
