package org.selectiverenderer.apartment.office;

import org.selectiverenderer.modelling.Degrees;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.Rounds;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;
import org.selectiverenderer.modelling.TriangleMesh;

/**
 * The form of a computer mouse, 0.115 m long, its buttons at +z.
 *
 * @param rings bands of the body from pole to pole
 * @param segments steps round the body
 */
record MouseShape(int rings, int segments) {
  private static final double HALF_WIDTH = 0.031;
  private static final double HEIGHT = 0.036;
  private static final double HALF_LENGTH = 0.0575;
  private static final double UPRIGHT = 2.3;
  private static final double LEVEL = 2.7;

  TriangleMesh body() {
    return Rounds.superellipsoid(HALF_WIDTH, HEIGHT, HALF_LENGTH, UPRIGHT, LEVEL, rings, segments)
        .deform(p -> p.y < 0 ? p.set(p.x, 0.12 * p.y, p.z) : p.mul(1, slope(p.z), 1))
        .deform(p -> p.mul(waist(p.z), 1, 1))
        .move(0, 0.12 * HEIGHT, 0);
  }

  /** Lower towards the buttons. */
  private static double slope(double z) {
    return 0.85 - 0.3 * z / HALF_LENGTH;
  }

  /** Narrower where thumb and little finger hold it. */
  private static double waist(double z) {
    double along = (z - 0.008) / HALF_LENGTH;
    return 0.88 + 0.12 * Math.min(1, along * along * 1.5);
  }

  /** Height of the body's upper side. */
  private static double top(double x, double z) {
    double level =
        Degrees.power(Math.abs(x / waist(z)) / HALF_WIDTH, LEVEL)
            + Degrees.power(Math.abs(z) / HALF_LENGTH, LEVEL);
    double rest = 1 - Degrees.power(level, UPRIGHT / LEVEL);
    return HEIGHT * (0.12 + slope(z) * Degrees.power(Math.max(0, rest), 1 / UPRIGHT));
  }

  /** The dark lines between the buttons and behind them. */
  TriangleMesh seams(int steps) {
    double back = 0.006;
    double[] along = new double[3 * (steps + 1)];
    double[] across = new double[3 * (steps + 1)];
    for (int i = 0; i <= steps; i++) {
      double z = back + (0.053 - back) * i / steps;
      double x = 0.026 * (2.0 * i / steps - 1);
      along[3 * i + 1] = top(0, z);
      along[3 * i + 2] = z;
      across[3 * i] = x;
      across[3 * i + 1] = top(x, back);
      across[3 * i + 2] = back;
    }
    Outline line = Outline.rectangle(0.0012, 0.0012);
    return Sweep.of(line, Spine.of(along)).append(Sweep.of(line, Spine.of(across)));
  }

  TriangleMesh wheel(int steps, int around) {
    double z = 0.032;
    return Placing.sideways(Rounds.torus(0.0075, 0.0036, steps, around))
        .move(0, top(0, z) - 0.005, z);
  }

  /** A cable that leaves between the buttons and goes on through the points. */
  TriangleMesh cable(int steps, int sides, double... points) {
    double[] all = new double[points.length + 6];
    all[1] = 0.009;
    all[2] = 0.05;
    all[4] = 0.006;
    all[5] = 0.068;
    System.arraycopy(points, 0, all, 6, points.length);
    return Sweep.tube(Spine.smooth(steps, all), 0.0021, sides);
  }
}
