package org.selectiverenderer.browser.movie.mpeg;

import java.util.Arrays;

/**
 * A decoded picture in YCbCr 4:2:0: a luma plane and two chroma planes of half the width and
 * height, all in whole macroblocks.
 */
final class YCbCrPicture {
  final int stride;
  final int rows;
  final byte[][] samples;

  /**
   * @param across the macroblocks per row, 16 pixels each
   * @param down the rows of macroblocks
   */
  YCbCrPicture(int across, int down) {
    stride = 16 * across;
    rows = 16 * down;
    samples = new byte[][] {new byte[stride * rows], colour(), colour()};
  }

  private byte[] colour() {
    byte[] plane = new byte[stride * rows / 4];
    Arrays.fill(plane, (byte) 128);
    return plane;
  }

  /** Returns the samples per row of a plane. */
  int stride(int plane) {
    return plane == 0 ? stride : stride / 2;
  }

  private int rows(int plane) {
    return plane == 0 ? rows : rows / 2;
  }

  /**
   * Copies a square of a reference picture to a place of this one (motion compensation),
   * interpolated between pixels for half-pixel vectors. Outside the reference its edge pixels are
   * repeated.
   *
   * @param size the side of the square in samples
   * @param right the horizontal motion vector in half pixels, positive to the right
   * @param down the vertical motion vector in half pixels, positive down
   * @param mix whether the result is averaged with the present samples
   */
  void predict(
      YCbCrPicture from, int plane, int x, int y, int size, int right, int down, boolean mix) {
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
   * Converts the picture to RGB (ITU-R BT.601).
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
