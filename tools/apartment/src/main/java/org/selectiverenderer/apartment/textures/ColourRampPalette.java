package org.selectiverenderer.apartment.textures;

import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;
import org.selectiverenderer.formats.image.Srgb;

/**
 * A palette of colour ramps for an indexed-colour image: a few dyes, each in many tones from dark
 * to light. The more dyes, the fewer tones of each.
 */
final class ColourRampPalette {
  private static final int COLOURS = 256;

  /**
   * Rounds of the search for the factors; palette bytes resolve about one in two hundred, so more
   * rounds change nothing.
   */
  private static final int ROUNDS = 8;

  /** Computes the colour of a point as a dye and a tone. */
  @FunctionalInterface
  interface Paint {
    /**
     * @param x metres to the right of the image's left edge
     * @param y metres above the image's lower edge
     * @return the dye's number plus the tone, 0 (dark) to below 1 (light)
     */
    double at(double x, double y);
  }

  private final int tones;
  private final double[] light;

  /**
   * @param ramps for each dye the display colours r, g, b of its darkest, middle and lightest tone
   */
  ColourRampPalette(double[]... ramps) {
    tones = COLOURS / ramps.length;
    light = new double[3 * tones * ramps.length];
    for (int dye = 0; dye < ramps.length; dye++) {
      for (int tone = 0; tone < tones; tone++) {
        double t = 2.0 * tone / (tones - 1);
        int from = t < 1 ? 0 : 3;
        for (int c = 0; c < 3; c++) {
          double display =
              PerlinNoise.mix(ramps[dye][from + c], ramps[dye][from + 3 + c], t < 1 ? t : t - 1);
          light[3 * (dye * tones + tone) + c] = Srgb.light(display);
        }
      }
    }
  }

  /** Encodes a dye and a tone as one number; tones are clamped to 0 to 1. */
  static double of(int dye, double tone) {
    return dye + Math.max(0, Math.min(0.9999, tone));
  }

  /**
   * Paints the image of a surface.
   *
   * @param across width that the image covers, metres, and so {@code up} its height
   * @param meanLight mean reflectance r, g, b that the image is scaled to
   */
  TextureImage paint(
      int width, int height, double across, double up, double[] meanLight, Paint paint) {
    byte[] pixels = new byte[width * height];
    long[] used = new long[COLOURS];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        double dyed = paint.at((x + 0.5) / width * across, (height - y - 0.5) / height * up);
        int dye = (int) dyed;
        int colour = dye * tones + (int) ((dyed - dye) * tones);
        pixels[y * width + x] = (byte) colour;
        used[colour]++;
      }
    }
    return new TextureImage(width, height, Samples.PALETTE, palette(used, meanLight), pixels);
  }

  /**
   * Returns the palette with red, green and blue scaled by one factor each, so that the mean
   * reflectance is reached.
   */
  private byte[] palette(long[] used, double[] meanLight) {
    byte[] palette = new byte[light.length];
    for (int c = 0; c < 3; c++) {
      double factor = 1;
      for (int round = 0; round < ROUNDS; round++) {
        double sum = 0;
        long all = 0;
        for (int i = 0; i < light.length / 3; i++) {
          int display =
              (int) Math.round(255 * Srgb.display(Math.min(1, factor * light[3 * i + c])));
          palette[3 * i + c] = (byte) display;
          sum += used[i] * Srgb.light(display / 255.0);
          all += used[i];
        }
        factor *= meanLight[c] * all / sum;
      }
    }
    return palette;
  }
}
