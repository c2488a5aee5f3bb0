package org.selectiverenderer.apartment.kitchen;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.SimplePolygon;

/**
 * Builds slabs with rounded edges whose faces are shaded flat: a narrow band between rounding and
 * face takes the gradient of the smoothed normals.
 */
final class RoundedSlabs {
  /**
   * Width of a rounding as a multiple of its height: so small that the one bevel which version 2
   * keeps of it is steep and is not smoothed into the face.
   */
  private static final double REACH = 0.5;

  /** End of the band, as a multiple of the rounding's height. */
  private static final double BAND = 0.8;

  private RoundedSlabs() {}

  /**
   * Returns a horizontal slab from y = 0 to y = thickness: {@code n (4 steps + 8)} triangles for an
   * outline of n points.
   *
   * @param outline convex, seen from above; about the origin
   * @param radius height of the rounding, metres; less than half the thickness
   * @param steps number of segments of the rounding
   */
  static TriangleMesh lying(SimplePolygon outline, double thickness, double radius, int steps) {
    List<Vector3d[]> rows = new ArrayList<>();
    rows.add(row(outline.inset(BAND * radius), 0));
    for (int i = 0; i <= steps; i++) {
      rows.add(rounding(outline, radius, 90.0 * i / steps, radius, -1));
    }
    for (int i = steps; i >= 0; i--) {
      rows.add(rounding(outline, radius, 90.0 * i / steps, thickness - radius, 1));
    }
    rows.add(row(outline.inset(BAND * radius), thickness));
    return LoftedSurface.over(rows, LoftedSurface.Form.CAPPED);
  }

  /** Returns an upright slab: the outline as seen from the front, its back at z = 0. */
  static TriangleMesh upright(SimplePolygon outline, double thickness, double radius, int steps) {
    return lying(outline, thickness, radius, steps).turnX(90);
  }

  private static Vector3d[] rounding(
      SimplePolygon outline, double radius, double degrees, double y, int up) {
    double inset = REACH * radius * (1 - DegreeMath.sin(degrees));
    return row(outline.inset(inset), y + up * radius * DegreeMath.cos(degrees));
  }

  /** Returns the points of an outline laid horizontally at a height. */
  static Vector3d[] row(SimplePolygon outline, double y) {
    Vector3d[] row = new Vector3d[outline.size()];
    for (int i = 0; i < row.length; i++) {
      row[i] = new Vector3d(outline.x(i), y, -outline.y(i));
    }
    return row;
  }
}
