package org.selectiverenderer.apartment.textures;

/** A texture of white glazed wall tiles with grey joints; it repeats after four by four tiles. */
final class WallTiles {
  /** Side of a tile, metres. */
  static final double TILE = 0.15;

  private static final int TILES = 4;

  /** Side of the square that the texture covers, metres. */
  static final double SIZE = TILES * TILE;

  /** Half the breadth of a joint, as a share of a tile. */
  private static final double JOINT = 0.012;

  /** Distance from a tile's edge, as a share of a tile, at which the rounding of the edge ends. */
  private static final double EDGE = 0.04;

  private static final int GLAZE = 0;
  private static final int MORTAR = 1;

  private static final ColourRampPalette GLAZES =
      new ColourRampPalette(
          new double[] {0.76, 0.75, 0.71, 0.92, 0.91, 0.88, 0.97, 0.965, 0.945},
          new double[] {0.5, 0.49, 0.46, 0.66, 0.65, 0.61, 0.78, 0.77, 0.73});

  private final PerlinNoise noise = new PerlinNoise(11);

  private WallTiles() {}

  /**
   * @param meanLight mean reflectance r, g, b
   */
  static TextureImage picture(double[] meanLight) {
    return GLAZES.paint(256, 256, TILES, TILES, meanLight, new WallTiles()::at);
  }

  /**
   * Returns dye and tone at a point, in tiles; joints run along the lower and the left edge of the
   * texture.
   */
  private double at(double x, double y) {
    int i = (int) x;
    int j = (int) y;
    double u = x - i;
    double v = y - j;
    double toEdge = Math.min(Math.min(u, 1 - u), Math.min(v, 1 - v));
    if (toEdge < JOINT) {
      return ColourRampPalette.of(
          MORTAR, 0.5 + 0.1 * noise.at(20 * x, 20 * y, 20 * TILES, 20 * TILES));
    }
    double tone = 0.5 + 0.12 * (noise.dice(i, j) - 0.5);
    tone += 0.03 * noise.layers(3, 2 * x, 2 * y, 2 * TILES, 2 * TILES);
    tone -= 0.2 * (1 - PerlinNoise.step(JOINT, EDGE, toEdge));
    return ColourRampPalette.of(GLAZE, tone);
  }
}
