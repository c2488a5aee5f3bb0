package org.selectiverenderer.apartment.office;

import org.joml.Vector3d;
import org.selectiverenderer.modelling.Curve;
import org.selectiverenderer.modelling.Extrusion;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.Sheet;
import org.selectiverenderer.modelling.TriangleMesh;

/**
 * A bound book that stands upright with its back to +z.
 *
 * @param thick measured along x, metres
 * @param height metres
 * @param deep from the back's roundest place to the fore edge, metres
 */
record Book(double thick, double height, double deep) {
  private static final double BOARD = 0.003;

  /** How far the back stands out. */
  private double round() {
    return 0.2 * thick;
  }

  private double front() {
    return deep / 2 - round();
  }

  /** Two boards and a round back of one piece: a U seen from above, open behind. */
  TriangleMesh cover() {
    double x = thick / 2;
    double inner = x - BOARD;
    Curve outside =
        Curve.from(x, deep / 2)
            .line(x, -front())
            .bezier(
                0.75 * x,
                -deep / 2 - 0.2 * round(),
                -0.75 * x,
                -deep / 2 - 0.2 * round(),
                -x,
                -front(),
                24)
            .line(-x, deep / 2);
    Curve inside =
        Curve.from(-inner, deep / 2)
            .line(-inner, -front() + BOARD)
            .bezier(
                -0.7 * inner,
                BOARD - deep / 2,
                0.7 * inner,
                BOARD - deep / 2,
                inner,
                BOARD - front(),
                16)
            .line(inner, deep / 2);
    return Extrusion.plate(height, 0.001, 4, outside.then(inside).closed());
  }

  /** A little lower than the boards, hollow at the fore edge. */
  TriangleMesh pages() {
    double x = thick / 2 - BOARD + 0.0005;
    Outline block =
        Curve.from(x, -front())
            .line(x, deep / 2 - 0.006)
            .bezier(0.5 * x, deep / 2 - 0.012, -0.5 * x, deep / 2 - 0.012, -x, deep / 2 - 0.006, 10)
            .line(-x, -front())
            .closed();
    return Extrusion.plate(height - 0.008, 0, 0, block).move(0, 0.004, 0);
  }

  /** A title plate and two bands on the back: open surfaces that follow its curve. */
  TriangleMesh label() {
    return TriangleMesh.of(
        strip(0.72 * height, 0.12 * height),
        strip(0.64 * height, 0.004),
        strip(0.12 * height, 0.004));
  }

  private TriangleMesh strip(double from, double length) {
    return Sheet.of(
        10,
        1,
        (u, v) -> {
          double t = 0.1 + 0.8 * u;
          double s = 1 - t;
          double x = thick / 2 * (s * s * s + 2.25 * s * s * t - 2.25 * s * t * t - t * t * t);
          double out = front() * (s * s * s + t * t * t) + 3 * s * t * (deep / 2 + 0.2 * round());
          return new Vector3d(-x, from + v * length, out + 0.0012);
        });
  }
}
