package org.selectiverenderer.runtime.movie.mpeg;

import java.util.Arrays;

/**
 * A picture as it is coded: a plane of brightness, and two of colour of half the size either way,
 * all in whole macroblocks.
 */
final class Planes {
  final int stride;
  final int rows;
  final byte[][] samples;

  /**
   * @param across macroblocks, 16 pixels each
   * @param down macroblocks
   */
  Planes(int across, int down) {
    stride = 16 * across;
    rows = 16 * down;
    samples = new byte[][] {new byte[stride * rows], colour(), colour()};
  }

  private byte[] colour() {
    byte[] plane = new byte[stride * rows / 4];
    Arrays.fill(plane, (byte) 128);
    return plane;
  }

  /** Samples of a plane's row. */
  int stride(int plane) {
    return plane == 0 ? stride : stride / 2;
  }

  private int rows(int plane) {
    return plane == 0 ? rows : rows / 2;
  }

  /**
   * Copies a square of another picture to a place of this one, from halfway between pixels where
   * the vector says so. What would lie outside is taken from the edge.
   *
   * @param size side of the square
   * @param right by how many half pixels it lies to the right of the place
   * @param down and below
   * @param mix whether the mean with what is there is kept
   */
  void predict(Planes from, int plane, int x, int y, int size, int right, int down, boolean mix) {
    byte[] source = from.samples[plane];
    byte[] target = samples[plane];
    int width = stride(plane);
    int fromX = Math.max(0, Math.min(width - size, x + (right >> 1)));
    int fromY = Math.max(0, Math.min(rows(plane) - size, y + (down >> 1)));
    int beside = (right & 1) != 0 && fromX + size < width ? 1 : 0;
    int below = (down & 1) != 0 && fromY + size < rows(plane) ? width : 0;
    int both = beside + below;
    for (int row = 0; row < size; row++) {
      int at = (fromY + row) * width + fromX;
      int to = (y + row) * width + x;
      for (int end = to + size; to < end; at++, to++) {
        int value = source[at] & 0xff;
        if (beside != 0 && below != 0) {
          value +=
              (source[at + beside] & 0xff)
                  + (source[at + below] & 0xff)
                  + (source[at + both] & 0xff);
          value = value + 2 >> 2;
        } else if (both != 0) {
          value = value + (source[at + both] & 0xff) + 1 >> 1;
        }
        target[to] = (byte) (mix ? (target[to] & 0xff) + value + 1 >> 1 : value);
      }
    }
  }

  /**
   * The picture in colours (ITU-R BT.601).
   *
   * @return four bytes r, g, b, a per pixel; the first row is the lowest
   */
  byte[] rgba(int width, int height) {
    byte[] rgba = new byte[4 * width * height];
    for (int y = 0; y < height; y++) {
      int at = 4 * width * (height - 1 - y);
      for (int x = 0; x < width; x++, at += 4) {
        int colour = y / 2 * (stride / 2) + x / 2;
        int light = 76309 * Math.max(0, (samples[0][y * stride + x] & 0xff) - 16) + 32768;
        int blue = (samples[1][colour] & 0xff) - 128;
        int red = (samples[2][colour] & 0xff) - 128;
        rgba[at] = clamp(light + 104597 * red >> 16);
        rgba[at + 1] = clamp(light - 25675 * blue - 53279 * red >> 16);
        rgba[at + 2] = clamp(light + 132201 * blue >> 16);
        rgba[at + 3] = (byte) 255;
      }
    }
    return rgba;
  }

  private static byte clamp(int value) {
    return (byte) Math.max(0, Math.min(255, value));
  }
}
