package org.selectiverenderer.apartment.textures;

/**
 * A texture of veneer of one log with upright grain, for doors. It repeats after 0.5 metres by 2.1.
 */
final class Veneer {
  static final double WIDTH = 0.5;
  static final double HEIGHT = 2.1;

  private static final ColourRampPalette WOOD =
      new ColourRampPalette(new double[] {0.24, 0.13, 0.06, 0.55, 0.36, 0.2, 0.72, 0.52, 0.33});

  private final PerlinNoise noise = new PerlinNoise(5);

  private Veneer() {}

  /**
   * @param meanLight mean reflectance r, g, b
   */
  static TextureImage picture(double[] meanLight) {
    return WOOD.paint(256, 256, 1, 1, meanLight, new Veneer()::at);
  }

  /** Returns dye and tone at a point across and along the grain, 0 to 1. */
  private double at(double u, double v) {
    // Growth rings bend slowly and are closer together towards the sheet's edges; whole periods
    // make the texture repeat.
    double bend = 1.3 * noise.at(2 * u, 2 * v, 2, 2) + 0.4 * noise.at(6 * u + 40, 5 * v, 6, 5);
    double rings = noise.at(22 * u + bend, 1.5, 22, 8);
    double fine = noise.at(58 * u + 2 * bend + 100, 2 * v, 58, 2);
    double fibres = noise.at(96 * u + 200, 10 * v, 96, 10);
    double pores = PerlinNoise.step(0.3, 0.8, noise.at(120 * u + 300, 40 * v, 120, 40));
    return ColourRampPalette.of(
        0, 0.55 + 0.11 * rings + 0.06 * fine + 0.04 * fibres - 0.12 * pores);
  }
}
