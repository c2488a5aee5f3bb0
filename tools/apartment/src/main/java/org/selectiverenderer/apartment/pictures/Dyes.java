package org.selectiverenderer.apartment.pictures;

import org.selectiverenderer.base.picture.PngPicture.Samples;
import org.selectiverenderer.base.picture.Srgb;

/**
 * A picture's few colours, each in many tones from dark to light: what a file of numbers of a
 * palette can say. The more dyes, the fewer tones of each.
 */
final class Dyes {
  private static final int COLOURS = 256;

  /** A palette's bytes tell light apart by one in two hundred; more rounds change nothing. */
  private static final int ROUNDS = 8;

  /** The colour of a place: a dye and a tone. */
  @FunctionalInterface
  interface Paint {
    /**
     * @param x metres to the right of the picture's left edge
     * @param y metres above its lower edge
     * @return the dye's number, whole, plus its tone, 0 (dark) to below 1 (light)
     */
    double at(double x, double y);
  }

  private final int tones;
  private final double[] light;

  /**
   * @param ramps for each dye the display's red, green and blue of its darkest, middle and lightest
   *     tone
   */
  Dyes(double[]... ramps) {
    tones = COLOURS / ramps.length;
    light = new double[3 * tones * ramps.length];
    for (int dye = 0; dye < ramps.length; dye++) {
      for (int tone = 0; tone < tones; tone++) {
        double t = 2.0 * tone / (tones - 1);
        int from = t < 1 ? 0 : 3;
        for (int c = 0; c < 3; c++) {
          double display =
              Noise.mix(ramps[dye][from + c], ramps[dye][from + 3 + c], t < 1 ? t : t - 1);
          light[3 * (dye * tones + tone) + c] = Srgb.light(display);
        }
      }
    }
  }

  /** A dye and a tone as one number; tones outside of 0 to 1 are the darkest and the lightest. */
  static double of(int dye, double tone) {
    return dye + Math.max(0, Math.min(0.9999, tone));
  }

  /**
   * The picture of a surface.
   *
   * @param across metres that it covers to the right, {@code up} likewise
   * @param meanLight share of light that it throws back on the whole, as the surface did before
   */
  SurfacePicture paint(
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
    return new SurfacePicture(width, height, Samples.PALETTE, palette(used, meanLight), pixels);
  }

  /** All colours lighter or darker by one factor for red, one for green, one for blue. */
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
