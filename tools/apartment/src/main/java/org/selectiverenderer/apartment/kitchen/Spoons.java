package org.selectiverenderer.apartment.kitchen;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** Four steel spoons side by side, two large ones and two small ones, lying along z. */
final class Spoons {
  private static final int ROWS = 39;
  private static final int AROUND = 24;
  private static final double LENGTH = 0.2;

  private Spoons() {}

  static ParametricModel model() {
    TriangleMesh large = spoon();
    TriangleMesh small = large.scale(0.74);
    return ModelPlacement.centred(
        "spoons",
        Part.of(
            "spoons",
            Materials.POLISHED_STEEL,
            large.turnY(4).move(-0.085, 0, 0),
            large.turnY(-2).move(-0.028, 0, 0.004),
            small.turnY(3).move(0.028, 0, 0.022),
            small.turnY(-5).move(0.075, 0, 0.026)));
  }

  /**
   * Returns a spoon lofted over oval sections from the bowl's tip at the back to the handle's end
   * in front.
   */
  private static TriangleMesh spoon() {
    List<Vector3d[]> rows = new ArrayList<>();
    for (int r = 0; r <= ROWS; r++) {
      // Half of the sections are spent on the bowl, a third of the length, since it curves most.
      double t = (double) r / ROWS;
      rows.add(section(t < 0.5 ? 0.68 * t : 1.32 * t - 0.32));
    }
    return LoftedSurface.over(rows, LoftedSurface.Form.CAPPED);
  }

  /** Returns the section at a share t of the length: sagging in the bowl, flat in the handle. */
  private static Vector3d[] section(double t) {
    double bowl = Math.max(0, 1 - square((t - 0.165) / 0.165));
    double handle = 0.0034 + 0.0062 * smooth((t - 0.4) / 0.5);
    double end = Math.sqrt(Math.max(0.02, 1 - square(Math.max(0, (t - 0.95) / 0.05))));
    double halfWidth = Math.max(0.021 * Math.sqrt(bowl), t > 0.16 ? handle * end : 0.001);
    double sag = 0.008 * Math.min(1, 1.25 * bowl);
    double height = 0.0092 + 0.012 * smooth((t - 0.26) / 0.22) - 0.0135 * smooth((t - 0.5) / 0.5);
    double half = 0.0009 + 0.0009 * smooth((t - 0.25) / 0.1) - 0.0006 * smooth((t - 0.5) / 0.4);
    Vector3d[] row = new Vector3d[AROUND];
    for (int i = 0; i < AROUND; i++) {
      double x = DegreeMath.cos(360.0 * i / AROUND);
      double y = height - sag * (1 - x * x) + half * DegreeMath.sin(360.0 * i / AROUND);
      row[i] = new Vector3d(halfWidth * x, y, LENGTH * (t - 0.5));
    }
    return row;
  }

  private static double smooth(double t) {
    double s = Math.max(0, Math.min(1, t));
    return s * s * (3 - 2 * s);
  }

  private static double square(double x) {
    return x * x;
  }
}
