package org.selectiverenderer.runtime.render.gpu;

import org.selectiverenderer.runtime.instance.Texture;

/**
 * Smaller versions of an image, each half as wide and high as the one before, as OpenGL has them
 * (OpenGL 3.3, 3.8.14). A software renderer draws them as pictures of pictures, each by a call of
 * its own, which takes thirty times as long.
 */
final class Mipmaps {
  /** The weights of a filter are so many parts of one. */
  private static final int BITS = 8;

  private static final int ONE = 1 << BITS;

  private int width;
  private int height;
  private byte[] rgba;

  /** Begins with the image itself. */
  Mipmaps(Texture.Image image) {
    this(image.width(), image.height(), image.rgba());
  }

  /**
   * @param rgba four bytes a pixel
   */
  Mipmaps(int width, int height, byte[] rgba) {
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

  /** The pixels of this version; not to be written to. */
  byte[] rgba() {
    return rgba;
  }

  /** Goes on to the next smaller version; false where this one is a single pixel. */
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

  /** The means of four pixels each. */
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

  /** What lies between the four pixels around the middle of each that is made. */
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

  /** Weighted; the weights' parts are not divided away. */
  private static int mix(int a, int b, int weight) {
    return a * (ONE - weight) + b * weight;
  }

  /** Where the middles of the pixels of a shorter row lie among the middles of a longer one's. */
  private static int[] places(int longer, int shorter) {
    int[] places = new int[shorter];
    for (int i = 0; i < shorter; i++) {
      double middle = (i + 0.5) * longer / shorter - 0.5;
      places[i] = (int) Math.round(Math.max(0, Math.min(longer - 1, middle)) * ONE);
    }
    return places;
  }
}
