package org.selectiverenderer.apartment.office;

import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.ProfileCurve;

/**
 * A bound book that stands upright with its spine to +z.
 *
 * @param thick thickness along x, metres
 * @param height metres
 * @param deep depth from the outermost line of the spine to the fore edge, metres
 */
record Book(double thick, double height, double deep) {
  private static final double BOARD = 0.003;

  /** Returns the distance by which the round spine stands out. */
  private double round() {
    return 0.13 * thick;
  }

  private double front() {
    return deep / 2 - round();
  }

  /** Returns two boards and a round spine of one piece: a U seen from above, open behind. */
  TriangleMesh cover() {
    double x = thick / 2;
    double inner = x - BOARD;
    ProfileCurve outside =
        ProfileCurve.from(x, deep / 2)
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
    ProfileCurve inside =
        ProfileCurve.from(-inner, deep / 2)
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
    return ExtrudedSolid.plate(height, 0.001, 4, outside.then(inside).closed());
  }

  /**
   * Returns the pages' upper edge and, going down behind, their concave fore edge: an open surface.
   */
  TriangleMesh pages() {
    double x = thick / 2 - BOARD + 0.0005;
    double upper = height - 0.004;
    return ParametricSurface.of(
        10,
        4,
        (u, v) -> {
          double side = 2 * u - 1;
          double hollow = deep / 2 - 0.006 - 0.006 * (1 - side * side);
          double back = Math.min(1, 2 * v);
          double down = Math.max(0, 2 * v - 1);
          return new Vector3d(
              side * x, upper - down * (upper - 0.004), front() - back * (front() + hollow));
        });
  }

  /**
   * Returns the title plate and a band below it, flat in front of the outermost line of the spine.
   */
  TriangleMesh label() {
    double out = deep / 2 + 0.0006;
    return TriangleMesh.of(
        MeshOrientation.flat(0.62 * thick, 0.13 * height).move(0, 0.75 * height, out),
        MeshOrientation.flat(0.62 * thick, 0.005).move(0, 0.16 * height, out));
  }
}
