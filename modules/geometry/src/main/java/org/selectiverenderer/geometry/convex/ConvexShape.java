package org.selectiverenderer.geometry.convex;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A closed, bounded convex body, defined by its support mapping. The X3D primitives are centred at
 * the origin.
 */
@FunctionalInterface
public interface ConvexShape {
  /**
   * Computes the support point, the point of the body that is farthest in a direction.
   *
   * @param direction a vector of any length; for the zero vector any point is correct
   * @return {@code out}
   */
  Vector3d farthest(Vector3dc direction, Vector3d out);

  /** Returns a box centred at the origin. */
  static ConvexShape box(double width, double height, double depth) {
    return (d, out) ->
        out.set(
            Math.copySign(width / 2, d.x()),
            Math.copySign(height / 2, d.y()),
            Math.copySign(depth / 2, d.z()));
  }

  /** Returns a sphere centred at the origin. */
  static ConvexShape sphere(double radius) {
    return (d, out) -> {
      double length = d.length();
      return length > 0 ? d.mul(radius / length, out) : out.set(radius, 0, 0);
    };
  }

  /** Returns a cylinder around the Y axis, centred at the origin. */
  static ConvexShape cylinder(double radius, double height) {
    return (d, out) -> rim(d, radius, Math.copySign(height / 2, d.y()), out);
  }

  /** Returns a cone around the Y axis, apex up, with half its height at the origin. */
  static ConvexShape cone(double radius, double height) {
    return (d, out) -> {
      double atRim = radius * Math.hypot(d.x(), d.z()) - d.y() * height / 2;
      return d.y() * height / 2 > atRim
          ? out.set(0, height / 2, 0)
          : rim(d, radius, -height / 2, out);
    };
  }

  private static Vector3d rim(Vector3dc d, double radius, double y, Vector3d out) {
    double level = Math.hypot(d.x(), d.z());
    double scale = level > 0 ? radius / level : 0;
    return out.set(d.x() * scale, y, d.z() * scale);
  }

  /**
   * Returns the convex hull of points.
   *
   * @param points x, y, z of each point; at least one point
   */
  static ConvexShape hull(double... points) {
    return (d, out) -> {
      int best = 0;
      double most = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < points.length; i += 3) {
        double along = points[i] * d.x() + points[i + 1] * d.y() + points[i + 2] * d.z();
        if (along > most) {
          most = along;
          best = i;
        }
      }
      return out.set(points[best], points[best + 1], points[best + 2]);
    };
  }
}
