package org.selectiverenderer.apartment.textures;

/**
 * A texture of oak parquet: boards of 525 by 70 millimetres that run to the right, each with its
 * own tone, hue and grain, their ends staggered irregularly; it repeats after 2.1 metres.
 */
final class Parquet {
  static final double SIZE = 2.1;

  private static final int ROWS = 30;
  private static final int PER_ROW = 4;
  private static final double LENGTH = SIZE / PER_ROW;
  private static final double BREADTH = SIZE / ROWS;

  /** Half the width of the dark gap between two boards, metres. */
  private static final double GAP = 0.0009;

  private static final ColourRampPalette OAK =
      new ColourRampPalette(
          new double[] {0.24, 0.13, 0.06, 0.58, 0.385, 0.225, 0.78, 0.585, 0.385},
          new double[] {0.25, 0.13, 0.06, 0.585, 0.38, 0.215, 0.785, 0.575, 0.37},
          new double[] {0.23, 0.13, 0.065, 0.575, 0.39, 0.23, 0.775, 0.59, 0.395});

  private final PerlinNoise grain = new PerlinNoise(1);
  private final PerlinNoise board = new PerlinNoise(2);

  private Parquet() {}

  /**
   * @param meanLight mean reflectance r, g, b
   */
  static TextureImage picture(double[] meanLight) {
    return OAK.paint(512, 1024, SIZE, SIZE, meanLight, new Parquet()::at);
  }

  private double at(double x, double y) {
    int row = Math.min(ROWS - 1, (int) (y / BREADTH));
    double inRow = y - row * BREADTH;
    double shifted = x - LENGTH * shift(row);
    int number = Math.floorMod((int) Math.floor(shifted / LENGTH), PER_ROW);
    double along = shifted - LENGTH * Math.floor(shifted / LENGTH);
    double toEdge = Math.min(inRow, BREADTH - inRow);
    double toEnd = Math.min(along, LENGTH - along);
    double tone = 0.52 + 0.2 * (board.dice(row, number) + board.dice(row, number + 10) - 1);
    tone += figure(row * PER_ROW + number, along, inRow);
    // Edges are a little rounded: they darken before they end.
    tone -=
        0.07 * (1 - PerlinNoise.step(0, 0.004, toEdge))
            + 0.07 * (1 - PerlinNoise.step(0, 0.005, toEnd));
    double open = Math.max(cover(toEdge, 0.001), cover(toEnd, 0.002));
    return ColourRampPalette.of(
        (int) (3 * board.dice(row, number + 20)), PerlinNoise.mix(tone, 0.1, 0.75 * open));
  }

  /** Returns the share of a pixel that a gap covers, at a distance from the gap's middle. */
  private static double cover(double distance, double half) {
    return Math.max(0, Math.min(1, (GAP + half - distance) / (2 * half))) * Math.min(1, GAP / half);
  }

  /**
   * Returns the offset of a row's board ends from the image's edge, in boards; those of adjacent
   * rows differ clearly.
   */
  private double shift(int row) {
    return (row * 0.381 + 0.25 * board.dice(row, 99)) % 1;
  }

  /** Returns the tone of the wood figure: growth rings cut lengthwise, fibres and pores. */
  private double figure(int number, double along, double across) {
    double from = 31.7 * number;
    double bend = 0.016 * grain.layers(2, from + 2.2 * along, 9 * across + number);
    // Cut near the heart, rings close in arches; far from it, they run straight.
    double heart = board.dice(number, 40);
    double arch = heart < 0.4 ? 0.5 * Math.abs(across - 0.03) * (along - 0.2) : 0;
    double ring = (across + bend + arch) * (90 + 110 * board.dice(number, 41));
    double rings = grain.at(from + 0.9 * along, ring + 500);
    double fibres = grain.at(from + 9 * along, 310 * across + 50 * number);
    double pores =
        PerlinNoise.step(0.35, 0.8, grain.at(from + 26 * along + 9, 420 * across + number));
    double cloud = grain.at(from + 3 * along, 14 * across + 7 * number);
    return 0.13 * rings + 0.06 * fibres - 0.13 * pores + 0.05 * cloud;
  }
}
