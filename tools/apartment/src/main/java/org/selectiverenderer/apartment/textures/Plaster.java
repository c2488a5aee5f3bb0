package org.selectiverenderer.apartment.textures;

import org.selectiverenderer.formats.image.CompactPngEncoder.Samples;
import org.selectiverenderer.formats.image.Srgb;

/**
 * A texture of roller-painted plaster in tones of grey, which is multiplied by the material's
 * colour: light and shade of small bumps, and traces of the roller. It repeats after 0.64 metres.
 */
final class Plaster {
  static final double SIZE = 0.64;

  /** Mean factor by which it scales its material's reflectance. */
  static final double MEAN_LIGHT = 0.9;

  private static final int PIXELS = 256;

  private final PerlinNoise noise = new PerlinNoise(4);

  private Plaster() {}

  static TextureImage picture() {
    Plaster plaster = new Plaster();
    double[] relief = new double[PIXELS * PIXELS];
    double sum = 0;
    for (int i = 0; i < relief.length; i++) {
      relief[i] = plaster.shade((double) (i % PIXELS) / PIXELS, (double) (i / PIXELS) / PIXELS);
      sum += relief[i];
    }
    byte[] pixels = new byte[relief.length];
    for (int i = 0; i < relief.length; i++) {
      double light = MEAN_LIGHT * (1 + relief[i] - sum / relief.length);
      pixels[i] = (byte) Math.round(255 * Srgb.display(Math.max(0, Math.min(1, light))));
    }
    return new TextureImage(PIXELS, PIXELS, Samples.GREY, new byte[0], pixels);
  }

  /**
   * Returns the relative change of light from above by the bumps; u and v from 0 to 1, v downwards.
   */
  private double shade(double u, double v) {
    double step = 0.5 / PIXELS;
    double slope = height(u, v + step) - height(u, v - step);
    double worn = noise.layers(2, 4 * u + 30, 4 * v, 4, 4);
    return 0.055 * slope + 0.012 * worn;
  }

  private double height(double u, double v) {
    double bumps = noise.at(72 * u, 72 * v, 72, 72);
    double roller = noise.at(28 * u + 60, 22 * v, 28, 22);
    return 2 * Math.max(-0.2, bumps) + 3 * roller;
  }
}
