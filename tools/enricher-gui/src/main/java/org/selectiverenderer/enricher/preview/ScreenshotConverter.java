package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
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
    for (int y = 0, at = 0; y < shot.height(); y++) {
      for (int x = 0; x < shot.width(); x++) {
        pixels[at++] = shot.rgb(x, shot.height() - 1 - y);
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
    // Dilate the mask along rows, then along columns: a separable square kernel.
    boolean[] mask = new boolean[width * height];
    boolean[] wide = new boolean[width * height];
    for (int y = 0; y < height; y++) {
      int row = y * width;
      for (int x = 0; x < width; x++) {
        if ((shot.rgba()[4 * ((height - 1 - y) * width + x) + 3] & 0xff) >= MASKED) {
          mask[row + x] = true;
          for (int i = Math.max(0, x - OUTLINE); i <= Math.min(width - 1, x + OUTLINE); i++) {
            wide[row + i] = true;
          }
        }
      }
    }
    int[] pixels = pixels(image);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
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
