package org.selectiverenderer.apartment.kitchen;

import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * Builds the doors and drawer fronts of the kitchen furniture and their handles; their backs are at
 * z = 0.
 */
final class CupboardFronts {
  static final double THICKNESS = 0.022;

  /** Gap between neighbouring fronts, metres. */
  private static final double GAP = 0.004;

  private static final double FRAME = 0.06;

  private CupboardFronts() {}

  /**
   * Returns a door: a frame with a bead around a recessed panel. Its edges are sharp, since a
   * chamfer in version 2 would be shaded as if the whole front were a cushion.
   */
  static TriangleMesh door(double x0, double y0, double x1, double y1) {
    SimplePolygon edge = SimplePolygon.rectangle(x1 - x0 - GAP, y1 - y0 - GAP);
    SimplePolygon opening = edge.inset(FRAME);
    TriangleMesh frame = ExtrudedSolid.plain(THICKNESS, edge, opening);
    TriangleMesh panel = ExtrudedSolid.plain(0.012, edge.inset(FRAME - 0.008));
    TriangleMesh bead =
        Sweep.of(SimplePolygon.circle(0.005, 8), Spine.of(opening)).move(0, 0, 0.013);
    return TriangleMesh.of(frame, panel, bead).move((x0 + x1) / 2, (y0 + y1) / 2, 0);
  }

  /** Returns a plain drawer front, which is too low for a frame. */
  static TriangleMesh drawer(double x0, double y0, double x1, double y1) {
    return ExtrudedSolid.bevelled(
            THICKNESS, 0.004, 3, SimplePolygon.rectangle(x1 - x0 - GAP, y1 - y0 - GAP))
        .move((x0 + x1) / 2, (y0 + y1) / 2, 0);
  }

  /** Returns a horizontal bow handle of steel, centred on (x, y). */
  static TriangleMesh bow(double length, double x, double y) {
    double half = length / 2;
    Spine line =
        Spine.smooth(
            3,
            -half,
            0,
            0,
            -half + 0.003,
            0,
            0.018,
            -half + 0.018,
            0,
            0.03,
            0,
            0,
            0.034,
            half - 0.018,
            0,
            0.03,
            half - 0.003,
            0,
            0.018,
            half,
            0,
            0);
    return Sweep.of(SimplePolygon.superellipse(0.005, 0.0065, 2.5, 10), line).move(x, y, THICKNESS);
  }

  static TriangleMesh knob(double x, double y) {
    ProfileCurve profile =
        ProfileCurve.of(0, 0, 0.009, 0, 0.006, 0.006, 0.006, 0.013)
            .spline(2, 0.0145, 0.021, 0.011, 0.027, 0, 0.029);
    return Lathe.solid(profile, 16).turnX(90).move(x, y, THICKNESS);
  }
}
