package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Builds round solids. Cylinders and cones stand on y = 0; spheres and rings are centred on the
 * origin.
 */
public final class RoundSolidBuilder {

  private RoundSolidBuilder() {}

  /**
   * Returns a sphere of {@code 2 segments (rings - 1)} triangles; rings are the bands from pole to
   * pole.
   */
  public static TriangleMesh sphere(double radius, int rings, int segments) {
    return ellipsoid(radius, radius, radius, rings, segments);
  }

  public static TriangleMesh ellipsoid(
      double radiusX, double radiusY, double radiusZ, int rings, int segments) {
    return superellipsoid(radiusX, radiusY, radiusZ, 2, 2, rings, segments);
  }

  /**
   * Returns a superellipsoid (Barr, 1981), for cushions, stones, soap.
   *
   * @param upright exponent of the outline seen from the side: 2 round, 4 squarish, 1 a double cone
   * @param level exponent of the outline seen from above
   */
  public static TriangleMesh superellipsoid(
      double radiusX,
      double radiusY,
      double radiusZ,
      double upright,
      double level,
      int rings,
      int segments) {
    SimplePolygon around = SimplePolygon.superellipse(1, 1, level, segments);
    List<Vector3d[]> rows = new ArrayList<>();
    for (int r = 0; r <= rings; r++) {
      double latitude = 180.0 * r / rings - 90;
      double width = SimplePolygon.bent(DegreeMath.cos(latitude), 2 / upright);
      double y = radiusY * SimplePolygon.bent(DegreeMath.sin(latitude), 2 / upright);
      Vector3d[] row = new Vector3d[segments];
      for (int s = 0; s < segments; s++) {
        row[s] = new Vector3d(radiusX * width * around.x(s), y, -radiusZ * width * around.y(s));
      }
      rows.add(row);
    }
    return LoftedSurface.over(rows, LoftedSurface.Form.PIPE);
  }

  /** Returns a cylinder of {@code 4 segments} triangles. */
  public static TriangleMesh cylinder(double radius, double height, int segments) {
    return cone(radius, radius, height, segments);
  }

  /** Returns a cone from one radius below to another above; a radius of 0 gives a tip. */
  public static TriangleMesh cone(double below, double above, double height, int segments) {
    return Lathe.solid(ProfileCurve.of(below, 0, above, height), segments);
  }

  /**
   * Returns a cylinder with rounded edges: {@code 4 segments (steps + 1)} triangles, or {@code 4
   * segments steps} less two if the roundings meet in the middle of its height.
   *
   * @param edge radius of the rounding, at most the cylinder's own and half its height
   */
  public static TriangleMesh roundedCylinder(
      double radius, double height, double edge, int steps, int segments) {
    ProfileCurve profile =
        ProfileCurve.from(radius - edge, 0)
            .arc(radius - edge, edge, 90, steps)
            .line(radius, height - edge)
            .arc(radius - edge, height - edge, 90, steps);
    return VertexWelding.weld(Lathe.solid(profile, segments));
  }

  /** Returns a cylinder with hemispheres at both ends, {@code height} in all. */
  public static TriangleMesh capsule(double radius, double height, int steps, int segments) {
    return roundedCylinder(radius, height, radius, steps, segments);
  }

  /** Returns a torus about the y axis, {@code 2 segments around} triangles. */
  public static TriangleMesh torus(double radius, double thickness, int segments, int around) {
    return Lathe.ring(SimplePolygon.circle(thickness, around).move(radius, 0), segments);
  }

  /** Returns a pipe that stands on y = 0, {@code 8 segments} triangles. */
  public static TriangleMesh pipe(double outer, double inner, double height, int segments) {
    return Lathe.ring(SimplePolygon.of(inner, 0, outer, 0, outer, height, inner, height), segments);
  }
}
