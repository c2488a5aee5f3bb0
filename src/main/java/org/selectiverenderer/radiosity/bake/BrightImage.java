package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.runtime.instance.Texture;

/**
 * An image as bright as it can be without changing what it shows but for factors of its colours: so
 * a picture of light that it is multiplied by needs to be no brighter than white.
 */
public final class BrightImage {
  /** What a colour is multiplied by at most: its 256 steps become coarse. */
  private static final double MOST = 4;

  private BrightImage() {}

  /** What red, green and blue can be multiplied by, at least 1. */
  static double[] gains(Texture.Image image) {
    int[] most = new int[3];
    byte[] rgba = image.rgba();
    for (int at = 0; at < rgba.length; at += 4) {
      for (int c = 0; c < 3; c++) {
        most[c] = Math.max(most[c], rgba[at + c] & 0xff);
      }
    }
    double[] gains = new double[3];
    for (int c = 0; c < 3; c++) {
      gains[c] = Math.min(MOST, 255.0 / Math.max(1, most[c]));
    }
    return gains;
  }

  /** The pixels multiplied, rows from the top: three bytes each, or four if it has alpha. */
  public static byte[] pixels(Texture.Image image) {
    double[] gains = gains(image);
    int each = image.translucent() ? 4 : 3;
    int width = image.width();
    byte[] out = new byte[each * width * image.height()];
    int at = 0;
    for (int y = image.height() - 1; y >= 0; y--) {
      for (int x = 0; x < width; x++) {
        int from = 4 * (y * width + x);
        for (int c = 0; c < 3; c++) {
          out[at++] = (byte) Math.round(gains[c] * (image.rgba()[from + c] & 0xff));
        }
        if (each == 4) {
          out[at++] = image.rgba()[from + 3];
        }
      }
    }
    return out;
  }
}
