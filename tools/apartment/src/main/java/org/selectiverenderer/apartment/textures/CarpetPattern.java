package org.selectiverenderer.apartment.textures;

import org.selectiverenderer.formats.image.Srgb;

/**
 * A quarter of a knotted carpet, its middle at the lower left: a teal field with a medallion,
 * lozenges and corners, and a border between two guards. Knots make slanting lines go in steps.
 */
final class CarpetPattern {
  /** Size of the quarter, metres. */
  private static final double ACROSS = 1.3;

  private static final double UP = 0.9;

  /** Size of a knot, metres; the pattern is drawn in knots. */
  private static final double KNOT = 0.01;

  private static final int TEAL = 0;
  private static final int CREAM = 1;
  private static final int RUST = 2;
  private static final int DARK = 3;

  /** The middle tones are those of the sofas' pillows. */
  private static final double[][] WOOL = {
    {0.06, 0.2, 0.22, 0.16, 0.4, 0.42, 0.3, 0.56, 0.57},
    {0.6, 0.54, 0.44, 0.86, 0.81, 0.7, 0.97, 0.94, 0.86},
    {0.4, 0.16, 0.08, 0.7, 0.34, 0.2, 0.84, 0.5, 0.34},
    {0.03, 0.09, 0.12, 0.1, 0.24, 0.28, 0.2, 0.36, 0.4}
  };

  /** Approximate share of the carpet of each colour. */
  private static final double[] SHARES = {0.44, 0.2, 0.1, 0.26};

  /** Factor of the wool's reflectance for pile seen from above. */
  private static final double LIGHT = 1.2;

  private final PerlinNoise noise = new PerlinNoise(8);

  private CarpetPattern() {}

  static TextureImage picture() {
    double[] meanLight = new double[3];
    for (int dye = TEAL; dye <= DARK; dye++) {
      for (int c = 0; c < 3; c++) {
        meanLight[c] += LIGHT * SHARES[dye] * Srgb.light(WOOL[dye][3 + c]);
      }
    }
    return new ColourRampPalette(WOOL)
        .paint(512, 360, ACROSS, UP, meanLight, new CarpetPattern()::at);
  }

  private double at(double x, double y) {
    double fuzz = 0.0025;
    double px = x + fuzz * noise.at(x * 170, y * 170);
    double py = y + fuzz * noise.at(x * 170 + 77, y * 170);
    double knotX = (Math.floor(px / KNOT) + 0.5) * KNOT;
    double knotY = (Math.floor(py / KNOT) + 0.5) * KNOT;
    double pile = 0.13 * noise.at(x * 240, y * 240) + 0.1 * noise.at(x * 110 + 9, y * 110);
    double knot = 0.12 * (noise.dice((int) (knotX / KNOT), (int) (knotY / KNOT)) - 0.5);
    // Wool is dyed in batches: stripes of slightly other tones.
    double batch = 0.07 * noise.layers(2, 2.3 * x, 8 * y);
    return ColourRampPalette.of(dye(knotX, knotY), 0.5 + pile + knot + batch);
  }

  private int dye(double x, double y) {
    double edge = Math.min(ACROSS - x, UP - y);
    double along = ACROSS - x < UP - y ? y : x;
    if (edge < 0.03) {
      return DARK;
    }
    if (edge < 0.06 || edge > 0.24 && edge < 0.265) {
      return Math.floorMod((int) Math.floor(along / 0.03), 2) == 0 && edge > 0.2 ? RUST : CREAM;
    }
    if (edge < 0.24) {
      boolean corner = Math.max(ACROSS - x, UP - y) < 0.24;
      return corner ? star(ACROSS - x - 0.15, UP - y - 0.15) : border(along, edge - 0.15);
    }
    return edge < 0.285 ? DARK : field(x, y);
  }

  /** Returns the colour of the border: lozenges in a row, hooks between them. */
  private static int border(double along, double across) {
    double step = 0.13;
    double u = Math.abs(along - step * (Math.floor(along / step) + 0.5)) / (step / 2);
    double v = Math.abs(across) / 0.075;
    double out = u + v;
    if (out < 0.35) {
      return CREAM;
    }
    if (out < 0.62) {
      return RUST;
    }
    return out < 0.85 ? CREAM : out > 1.5 ? TEAL : DARK;
  }

  /**
   * Returns the colour of the star where two borders meet; x and y from the middle of that square.
   */
  private static int star(double x, double y) {
    double out = Math.min(Math.abs(x) + Math.abs(y), 1.4 * Math.max(Math.abs(x), Math.abs(y)));
    return out < 0.02 ? CREAM : out < 0.05 ? RUST : out < 0.07 ? CREAM : DARK;
  }

  private static int field(double x, double y) {
    double medallion = x / 0.62 + y / 0.46;
    if (medallion < 1) {
      return medallion(medallion, x, y);
    }
    double corner = (ACROSS - 0.285 - x) / 0.34 + (UP - 0.285 - y) / 0.3;
    if (corner < 1) {
      return corner > 0.86 ? CREAM : corner > 0.72 ? DARK : corner > 0.3 ? RUST : CREAM;
    }
    if (medallion < 1.14 || corner < 1.2) {
      return TEAL;
    }
    // Small lozenges, every other row shifted by half.
    double row = Math.floor(y / 0.12);
    double u = x / 0.14 + (Math.floorMod((int) row, 2) == 0 ? 0 : 0.5);
    double out = Math.abs(u - Math.floor(u) - 0.5) * 2 + Math.abs(y / 0.12 - row - 0.5) * 2;
    return out < 0.2 ? RUST : out < 0.42 ? CREAM : TEAL;
  }

  private static int medallion(double out, double x, double y) {
    if (out > 0.91) {
      return CREAM;
    }
    if (out > 0.82) {
      return DARK;
    }
    if (out > 0.42) {
      double rays = Math.abs(x / 0.62 - y / 0.46);
      return rays < 0.07 || Math.abs(out - 0.62) < 0.04 ? CREAM : RUST;
    }
    return out > 0.34 ? CREAM : out > 0.2 ? DARK : out > 0.08 ? CREAM : RUST;
  }
}
