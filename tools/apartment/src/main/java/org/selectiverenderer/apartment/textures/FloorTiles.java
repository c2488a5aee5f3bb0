package org.selectiverenderer.apartment.textures;

/**
 * A chequered texture of glazed floor tiles, light and dark, with sand-coloured joints; it repeats
 * after four by four tiles.
 */
final class FloorTiles {
  static final int TILES = 4;

  /** Half the breadth of a joint, as a share of a tile. */
  private static final double JOINT = 0.008;

  /** Distance from a tile's edge, as a share of a tile, at which the rounding of the edge ends. */
  private static final double EDGE = 0.022;

  private static final int LIGHT = 0;
  private static final int DARK = 1;
  private static final int MORTAR = 2;

  private static final ColourRampPalette GLAZES =
      new ColourRampPalette(
          new double[] {0.55, 0.51, 0.45, 0.82, 0.79, 0.72, 0.93, 0.91, 0.86},
          new double[] {0.28, 0.14, 0.1, 0.54, 0.34, 0.26, 0.72, 0.5, 0.4},
          new double[] {0.36, 0.34, 0.3, 0.6, 0.57, 0.51, 0.74, 0.71, 0.65});

  private final PerlinNoise noise = new PerlinNoise(3);

  private FloorTiles() {}

  /**
   * @param meanLight mean reflectance r, g, b
   */
  static TextureImage picture(double[] meanLight) {
    return GLAZES.paint(512, 512, TILES, TILES, meanLight, new FloorTiles()::at);
  }

  /** Returns dye and tone at a point, in tiles. */
  private double at(double x, double y) {
    int i = (int) x;
    int j = (int) y;
    double u = x - i;
    double v = y - j;
    double mottle = noise.layers(4, 3 * x, 3 * y, 3 * TILES, 3 * TILES);
    double grains = noise.at(40 * x, 40 * y, 40 * TILES, 40 * TILES);
    // Tiles laid by hand: corners rounded, none quite straight.
    double toEdge = Math.min(Math.min(u, 1 - u), Math.min(v, 1 - v));
    double cut = toEdge + 0.002 * noise.at(6 * x + 50, 6 * y, 6 * TILES, 6 * TILES);
    if (cut < JOINT) {
      return ColourRampPalette.of(MORTAR, 0.45 + 0.12 * grains + 0.1 * mottle);
    }
    boolean light = (i + j) % 2 == 0;
    double tone = 0.5 + 0.16 * (noise.dice(i, j) - 0.5);
    tone += (light ? 0.07 : 0.1) * mottle + 0.03 * grains;
    tone -= 0.16 * (1 - PerlinNoise.step(JOINT, EDGE, cut));
    return ColourRampPalette.of(light ? LIGHT : DARK, tone);
  }
}
