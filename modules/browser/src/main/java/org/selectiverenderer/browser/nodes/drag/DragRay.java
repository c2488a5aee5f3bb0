package org.selectiverenderer.browser.nodes.drag;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The ray of the pointer in the local coordinates of a drag sensor.
 *
 * @param direction the direction, of any length but 0
 */
record DragRay(Vector3dc origin, Vector3dc direction) {

  Vector3d at(double distance) {
    return new Vector3d(origin).fma(distance, direction);
  }

  /**
   * Returns the intersection with the plane through a point with a given normal; empty if the plane
   * is behind the origin or parallel to the ray.
   */
  Optional<Vector3d> onPlane(Vector3dc point, Vector3dc normal) {
    double along = direction.dot(normal);
    double distance = point.sub(origin, new Vector3d()).dot(normal) / along;
    return distance >= 0 && Double.isFinite(distance)
        ? Optional.of(at(distance))
        : Optional.empty();
  }

  /**
   * Returns the intersection with a sphere about the origin of the coordinates, or with a cylinder
   * about the axis that {@code axes} leaves out. If the ray misses it, returns the ray's nearest
   * point.
   *
   * @param axes 1 for each coordinate that counts for the radius, 0 for the others
   * @param far whether to return the second of two intersections
   */
  Vector3d atRadius(double radius, Vector3dc axes, boolean far) {
    double a = direction.mul(axes, new Vector3d()).lengthSquared();
    if (!(a > 0)) {
      return new Vector3d(origin); // Parallel to the axis: all points are equally near.
    }
    double half = direction.mul(axes, new Vector3d()).dot(origin) / a;
    double rest = origin.mul(axes, new Vector3d()).lengthSquared() - radius * radius;
    double root = half * half - rest / a;
    double distance = root > 0 ? -half + (far ? 1 : -1) * Math.sqrt(root) : -half;
    return at(Math.max(0, distance));
  }
}
