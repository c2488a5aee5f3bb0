package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;
import org.selectiverenderer.render.context.Screenshot;

/** Converts the renderer's screenshots to images of Swing. */
final class ScreenshotConverter {
  /** Half the width of an outline in pixels. */
  private static final int OUTLINE = 2;

  private static final int MASKED = 128;

  private ScreenshotConverter() {}

  /** Converts a screenshot, whose rows run from bottom to top; ignores alpha. */
  static BufferedImage of(Screenshot shot) {
    BufferedImage image =
        new BufferedImage(shot.width(), shot.height(), BufferedImage.TYPE_INT_RGB);
    int[] pixels = pixels(image);
    byte[] rgba = shot.rgba();
    for (int y = 0, at = 0; y < shot.height(); y++) {
      int from = 4 * (shot.height() - 1 - y) * shot.width();
      for (int end = from + 4 * shot.width(); from < end; from += 4) {
        pixels[at++] =
            (rgba[from] & 0xff) << 16 | (rgba[from + 1] & 0xff) << 8 | rgba[from + 2] & 0xff;
      }
    }
    return image;
  }

  /**
   * Converts as {@link #of} and draws an outline around the pixels that the alpha channel masks,
   * which stay unchanged.
   *
   * @param rgb the colour of the outline
   */
  static BufferedImage outlined(Screenshot shot, int rgb) {
    BufferedImage image = of(shot);
    int width = shot.width();
    int height = shot.height();
    byte[] rgba = shot.rgba();
    // Dilate the mask along rows, then along columns: a separable square kernel.
    boolean[] mask = new boolean[width * height];
    boolean[] wide = new boolean[width * height];
    int left = width; // Of the columns and rows of the dilated mask.
    int right = 0;
    int top = height;
    int bottom = 0;
    for (int y = 0; y < height; y++) {
      int row = y * width;
      int from = 4 * (height - 1 - y) * width + 3;
      for (int x = 0; x < width; x++) {
        if ((rgba[from + 4 * x] & 0xff) >= MASKED) {
          mask[row + x] = true;
          int first = Math.max(0, x - OUTLINE);
          int end = Math.min(width, x + OUTLINE + 1);
          Arrays.fill(wide, row + first, row + end, true);
          left = Math.min(left, first);
          right = Math.max(right, end);
          top = Math.min(top, y);
          bottom = y + 1;
        }
      }
    }
    int[] pixels = pixels(image);
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        if (wide[y * width + x]) {
          for (int i = Math.max(0, y - OUTLINE); i <= Math.min(height - 1, y + OUTLINE); i++) {
            if (!mask[i * width + x]) {
              pixels[i * width + x] = rgb;
            }
          }
        }
      }
    }
    return image;
  }

  private static int[] pixels(BufferedImage image) {
    return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
  }
}
