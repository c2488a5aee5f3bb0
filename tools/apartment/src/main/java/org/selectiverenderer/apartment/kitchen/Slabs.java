package org.selectiverenderer.apartment.kitchen;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.Degrees;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Outline;
import org.selectiverenderer.modelling.Skin;

/**
 * Flat things with round edges whose faces look flat: a narrow band between rounding and face takes
 * the bend of the smoothed normals.
 */
final class Slabs {
  /**
   * How far a rounding reaches inwards as a multiple of its height: so little that the one bevel
   * which version 2 keeps of it is steep, and is no more smoothed into the face.
   */
  private static final double REACH = 0.5;

  /** Where the band ends, as a multiple of the rounding's height. */
  private static final double BAND = 0.8;

  private Slabs() {}

  /**
   * A lying plate from y = 0 to y = thickness: {@code n (4 steps + 8)} triangles for an outline of
   * n points.
   *
   * @param outline convex, seen from above; about the origin
   * @param radius height of the rounding, less than half the thickness
   * @param steps of the rounding
   */
  static TriangleMesh lying(Outline outline, double thickness, double radius, int steps) {
    List<Vector3d[]> rows = new ArrayList<>();
    rows.add(row(outline.inset(BAND * radius), 0));
    for (int i = 0; i <= steps; i++) {
      rows.add(rounding(outline, radius, 90.0 * i / steps, radius, -1));
    }
    for (int i = steps; i >= 0; i--) {
      rows.add(rounding(outline, radius, 90.0 * i / steps, thickness - radius, 1));
    }
    rows.add(row(outline.inset(BAND * radius), thickness));
    return Skin.over(rows, Skin.Form.CAPPED);
  }

  /** The same, upright: the outline as seen from the front, its back at z = 0. */
  static TriangleMesh upright(Outline outline, double thickness, double radius, int steps) {
    return lying(outline, thickness, radius, steps).turnX(90);
  }

  private static Vector3d[] rounding(
      Outline outline, double radius, double degrees, double y, int up) {
    double inset = REACH * radius * (1 - Degrees.sin(degrees));
    return row(outline.inset(inset), y + up * radius * Degrees.cos(degrees));
  }

  /** An outline lying at a height. */
  static Vector3d[] row(Outline outline, double y) {
    Vector3d[] row = new Vector3d[outline.size()];
    for (int i = 0; i < row.length; i++) {
      row[i] = new Vector3d(outline.x(i), y, -outline.y(i));
    }
    return row;
  }
}
