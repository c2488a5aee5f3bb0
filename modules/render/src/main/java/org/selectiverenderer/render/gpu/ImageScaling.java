package org.selectiverenderer.render.gpu;

import org.selectiverenderer.browser.instance.Texture;

/** Resamples images to other sizes. */
final class ImageScaling {
  private ImageScaling() {}

  /**
   * Scales a layer of an image by a box filter: each pixel is the mean of those that it covers, or
   * the nearest where it covers less than one.
   *
   * @return the image's own bytes where nothing changes
   */
  static byte[] to(Texture.Image image, int layer, int width, int height) {
    if (image.layers() == 1 && width == image.width() && height == image.height()) {
      return image.rgba();
    }
    byte[] out = new byte[width * height * 4];
    int base = layer * image.width() * image.height();
    for (int y = 0; y < height; y++) {
      int top = (int) ((long) y * image.height() / height);
      int bottom = Math.max(top + 1, (int) ((long) (y + 1) * image.height() / height));
      for (int x = 0; x < width; x++) {
        int left = (int) ((long) x * image.width() / width);
        int right = Math.max(left + 1, (int) ((long) (x + 1) * image.width() / width));
        for (int c = 0; c < 4; c++) {
          long sum = 0;
          for (int v = top; v < bottom; v++) {
            for (int u = left; u < right; u++) {
              sum += image.rgba()[4 * (base + v * image.width() + u) + c] & 0xff;
            }
          }
          int count = (bottom - top) * (right - left);
          out[4 * (y * width + x) + c] = (byte) ((sum + count / 2) / count);
        }
      }
    }
    return out;
  }

  /** Rotates an image by 180 degrees. */
  static byte[] turnedRound(byte[] rgba) {
    byte[] out = new byte[rgba.length];
    for (int i = 0; i < rgba.length; i += 4) {
      System.arraycopy(rgba, i, out, rgba.length - 4 - i, 4);
    }
    return out;
  }
}
