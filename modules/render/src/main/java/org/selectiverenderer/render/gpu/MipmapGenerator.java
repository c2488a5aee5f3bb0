package org.selectiverenderer.render.gpu;

import org.selectiverenderer.browser.instance.Texture;

/**
 * Generates the mipmap levels of an image, each half as wide and high as the one before (OpenGL
 * 3.3, 3.8.14). A software renderer's glGenerateMipmap draws each level as a textured rectangle,
 * which takes thirty times as long.
 */
final class MipmapGenerator {
  /** The fixed-point precision of filter weights. */
  private static final int BITS = 8;

  private static final int ONE = 1 << BITS;

  private int width;
  private int height;
  private byte[] rgba;

  /** Begins with the image itself as level 0. */
  MipmapGenerator(Texture.Image image) {
    this(image.width(), image.height(), image.rgba());
  }

  /**
   * @param rgba four bytes a pixel
   */
  MipmapGenerator(int width, int height, byte[] rgba) {
    this.width = width;
    this.height = height;
    this.rgba = rgba;
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** Returns the pixels of this level; not to be written to. */
  byte[] rgba() {
    return rgba;
  }

  /** Goes on to the next smaller level; returns false if this one is a single pixel. */
  boolean next() {
    if (width == 1 && height == 1) {
      return false;
    }
    int w = Math.max(1, width / 2);
    int h = Math.max(1, height / 2);
    rgba = width % 2 == 0 && height % 2 == 0 ? quarters(w, h) : between(w, h);
    width = w;
    height = h;
    return true;
  }

  /** Averages four pixels each. */
  private byte[] quarters(int w, int h) {
    byte[] out = new byte[4 * w * h];
    int row = 4 * width;
    int at = 0;
    for (int y = 0; y < h; y++) {
      int from = 2 * y * row;
      for (int x = 0; x < w; x++, from += 8) {
        for (int c = from; c < from + 4; c++) {
          int sum =
              (rgba[c] & 0xff)
                  + (rgba[c + 4] & 0xff)
                  + (rgba[c + row] & 0xff)
                  + (rgba[c + row + 4] & 0xff);
          out[at++] = (byte) (sum + 2 >> 2);
        }
      }
    }
    return out;
  }

  /** Interpolates bilinearly between the four pixels around the centre of each new pixel. */
  private byte[] between(int w, int h) {
    byte[] out = new byte[4 * w * h];
    int[] left = places(width, w);
    int[] below = places(height, h);
    int at = 0;
    for (int y = 0; y < h; y++) {
      int low = 4 * width * (below[y] >> BITS);
      int high = Math.min(low + 4 * width, 4 * width * (height - 1));
      int up = below[y] & ONE - 1;
      for (int x = 0; x < w; x++) {
        int near = 4 * (left[x] >> BITS);
        int far = Math.min(near + 4, 4 * (width - 1));
        int right = left[x] & ONE - 1;
        for (int c = 0; c < 4; c++) {
          int lower = mix(rgba[low + near + c] & 0xff, rgba[low + far + c] & 0xff, right);
          int upper = mix(rgba[high + near + c] & 0xff, rgba[high + far + c] & 0xff, right);
          out[at++] = (byte) (mix(lower, upper, up) + (1 << 2 * BITS - 1) >> 2 * BITS);
        }
      }
    }
    return out;
  }

  /** Returns the weighted sum in fixed point, without dividing by {@link #ONE}. */
  private static int mix(int a, int b, int weight) {
    return a * (ONE - weight) + b * weight;
  }

  /** Returns the positions of a shorter row's pixel centres in a longer row, in fixed point. */
  private static int[] places(int longer, int shorter) {
    int[] places = new int[shorter];
    for (int i = 0; i < shorter; i++) {
      double middle = (i + 0.5) * longer / shorter - 0.5;
      places[i] = (int) Math.round(Math.max(0, Math.min(longer - 1, middle)) * ONE);
    }
    return places;
  }
}
