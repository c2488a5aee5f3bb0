package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ExtrudedSolid;
import org.selectiverenderer.modelling.Lathe;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.MeshPatterns;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.ProfileCurve;
import org.selectiverenderer.modelling.SimplePolygon;

/** A coffee table of walnut, 1.2 m by 0.7 m and 0.43 m high, with turned legs and a shelf below. */
final class LoungeTable {
  private static final double WIDTH = 1.2;
  private static final double DEPTH = 0.7;
  private static final double TOP = 0.43;
  private static final double LEG_X = 0.52;
  private static final double LEG_Z = 0.27;

  private LoungeTable() {}

  static ParametricModel model() {
    return ParametricModel.of(
        "loungeTable",
        Part.of("top", Materials.WALNUT, top()).crease(40),
        Part.of("apron", Materials.WALNUT, apron()),
        Part.of("legs", Materials.WALNUT, MeshPatterns.corners(leg(), LEG_X, LEG_Z)).crease(50),
        Part.of("shelf", Materials.WALNUT, shelf()));
  }

  /** Returns the table top with a moulded edge: a hollow below, a step, a quarter round above. */
  private static TriangleMesh top() {
    SimplePolygon outline = SimplePolygon.roundedRectangle(WIDTH, DEPTH, 0.06, 9);
    ProfileCurve edge =
        ProfileCurve.from(0.03, TOP - 0.034)
            .arc(0.03, TOP - 0.012, 75, 6)
            .line(0.006, TOP - 0.016)
            .line(0.001, TOP - 0.015)
            .line(0, TOP - 0.012)
            .arc(0.012, TOP - 0.012, -90, 8);
    List<Vector3d[]> rows = new ArrayList<>();
    for (int i = 0; i < edge.size(); i++) {
      SimplePolygon level = edge.x(i) == 0 ? outline : outline.inset(edge.x(i));
      Vector3d[] row = new Vector3d[level.size()];
      for (int k = 0; k < row.length; k++) {
        row[k] = new Vector3d(level.x(k), edge.y(i), -level.y(k));
      }
      rows.add(row);
    }
    return LoftedSurface.over(rows, LoftedSurface.Form.CAPPED);
  }

  private static TriangleMesh apron() {
    TriangleMesh side = BoxBuilder.bevelled(2 * LEG_X - 0.05, 0.06, 0.022, 0.004, 2);
    TriangleMesh end = BoxBuilder.bevelled(0.022, 0.06, 2 * LEG_Z - 0.05, 0.004, 2);
    double y = TOP - 0.092;
    return TriangleMesh.of(
        side.move(0, y, LEG_Z),
        side.move(0, y, -LEG_Z),
        end.move(LEG_X, y, 0),
        end.move(-LEG_X, y, 0));
  }

  /** Returns a leg with a square block for the apron above, turned below: beads, a vase, a foot. */
  private static TriangleMesh leg() {
    ProfileCurve turned =
        ProfileCurve.from(0.012, 0)
            .spline(4, 0.019, 0.004, 0.023, 0.018, 0.018, 0.032)
            .spline(3, 0.013, 0.036, 0.0165, 0.044, 0.013, 0.05)
            .spline(8, 0.016, 0.09, 0.0265, 0.2, 0.0225, 0.262)
            .spline(3, 0.016, 0.278, 0.022, 0.286, 0.0165, 0.294)
            .spline(3, 0.0245, 0.303, 0.026, 0.31, 0.022, 0.322);
    TriangleMesh block = BoxBuilder.bevelled(0.05, 0.085, 0.05, 0.004, 3).move(0, 0.314, 0);
    return Lathe.solid(turned, 40).append(block);
  }

  private static TriangleMesh shelf() {
    SimplePolygon outline =
        SimplePolygon.roundedRectangle(2 * LEG_X + 0.02, 2 * LEG_Z + 0.02, 0.02, 6);
    TriangleMesh plate = ExtrudedSolid.plate(0.018, 0.008, 5, outline);
    return plate.move(0, 0.115, 0);
  }
}
