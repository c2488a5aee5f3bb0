package org.selectiverenderer.apartment.kitchen;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.RoundSolidBuilder;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/**
 * Builds the fittings of the worktop: sink, tap and hob, with the worktop's upper side at y = 0 and
 * the sink at x = 0.
 */
final class SinkAndHob {
  /** The opening in the worktop. */
  static final SimplePolygon OPENING = SimplePolygon.roundedRectangle(0.46, 0.38, 0.06, 6);

  private SinkAndHob() {}

  /** Returns a steel basin with a flat rim, open below since it is visible from above only. */
  static TriangleMesh basin() {
    // Offset of the outline and height of each row, from the rim's outer edge over the wall to the
    // bottom.
    double[] rings = {
      0.022, 0.0005, 0.02, 0.003, 0.004, 0.003, -0.003, 0.0005, -0.006, -0.008, -0.012, -0.13,
      -0.016, -0.146, -0.025, -0.156, -0.04, -0.16
    };
    List<Vector3d[]> rows = new ArrayList<>();
    for (int r = 0; r < rings.length; r += 2) {
      rows.add(RoundedSlabs.row(OPENING.inset(-rings[r]), rings[r + 1]));
    }
    rows.add(RoundedSlabs.row(SimplePolygon.circle(0.035, OPENING.size()), -0.164));
    rows.add(RoundedSlabs.row(SimplePolygon.circle(0.03, OPENING.size()), -0.168));
    rows.add(new Vector3d[] {new Vector3d(0, -0.168, 0)});
    return LoftedSurface.over(rows, LoftedSurface.Form.PIPE);
  }

  /** Returns a swan neck tap with one lever, behind the basin. */
  static TriangleMesh tap() {
    ProfileCurve foot =
        ProfileCurve.of(
            0, 0, 0.027, 0, 0.027, 0.006, 0.022, 0.009, 0.02, 0.07, 0.017, 0.078, 0, 0.078);
    Spine neck =
        Spine.smooth(
            4, 0, 0.07, 0, 0, 0.16, 0, 0.0, 0.24, 0.012, 0, 0.285, 0.06, 0, 0.285, 0.12, 0, 0.25,
            0.165, 0, 0.205, 0.178);
    TriangleMesh lever =
        Sweep.tube(Spine.of(0.018, 0.05, 0, 0.035, 0.055, 0, 0.095, 0.085, 0), 0.0055, 12);
    return TriangleMesh.of(Lathe.solid(foot, 24), Sweep.tube(neck, 0.0115, 14), lever)
        .move(0, 0, -0.235);
  }

  /** Returns the hob's black glass with a polished edge. */
  static TriangleMesh hobGlass() {
    return ExtrudedSolid.plate(
        0.007, 0.003, 2, SimplePolygon.roundedRectangle(0.56, 0.5, 0.015, 3));
  }

  /** Returns the four cooking zones, as rings on the glass. */
  static TriangleMesh hobRings() {
    TriangleMesh large = RoundSolidBuilder.pipe(0.1, 0.094, 0.001, 36).move(0, 0.0068, 0);
    TriangleMesh small = RoundSolidBuilder.pipe(0.075, 0.069, 0.001, 32).move(0, 0.0068, 0);
    return TriangleMesh.of(
        large.move(-0.14, 0, 0.11),
        small.move(0.15, 0, 0.125),
        small.move(-0.15, 0, -0.125),
        large.move(0.14, 0, -0.11));
  }
}
