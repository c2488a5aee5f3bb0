package org.selectiverenderer.apartment.textures;

import org.jspecify.annotations.Nullable;

/**
 * A house of two storeys in the landscape, its eaves towards the viewer.
 *
 * @param broad width, metres
 * @param wall colour of the wall, 0 white to 1 ochre
 */
record House(double turn, double distance, double broad, double wall)
    implements LandscapeBillboard {
  private static final double EAVES = 5.6;
  private static final double RIDGE = 9;

  @Override
  public double reach() {
    return broad / 2 + 0.4;
  }

  @Override
  public double top() {
    return RIDGE + 1;
  }

  @Override
  public double @Nullable [] colour(double right, double up) {
    double half = broad / 2;
    if (up > EAVES) {
      boolean chimney = up < RIDGE + 1 && Math.abs(right - 0.2 * broad) < 0.4;
      boolean roof = up < RIDGE && Math.abs(right) < half + 0.4 - 0.35 * (up - EAVES);
      double tiles = 0.03 * ((int) (up * 4) % 2);
      return roof
          ? new double[] {0.62 + tiles, 0.38 + tiles, 0.31 + tiles}
          : chimney ? new double[] {0.6, 0.45, 0.38} : null;
    }
    if (Math.abs(right) > half) {
      return null;
    }
    double column = (right + half) / broad * 4;
    double u = column - Math.floor(column);
    double storey = up / (EAVES / 2);
    double v = storey - Math.floor(storey);
    if (u > 0.32 && u < 0.68 && v > 0.34 && v < 0.84) {
      return new double[] {0.34, 0.4, 0.46};
    }
    double shade = up > EAVES - 0.5 ? 0.85 : 1;
    return new double[] {
      shade * (0.9 - 0.02 * wall), shade * (0.88 - 0.08 * wall), shade * (0.83 - 0.2 * wall)
    };
  }
}
