package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.browser.instance.Texture;

/**
 * Brightens a texture as far as its 8-bit channels allow, by one factor per channel, so that the
 * lightmap that it is multiplied by need not be brighter than white.
 */
public final class BrightenedImage {
  /** Largest factor of a channel: beyond it the 256 steps become coarse. */
  private static final double MOST = 4;

  private BrightenedImage() {}

  /** Returns the factors by which red, green and blue can be multiplied, at least 1. */
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

  /**
   * Returns the brightened pixels, rows from the top: three bytes each, or four if the image has
   * alpha.
   */
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
