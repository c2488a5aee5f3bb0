package org.selectiverenderer.runtime.nodes.drag;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Where the pointer points, in coordinates of a drag sensor.
 *
 * @param direction of any length but 0
 */
record DragRay(Vector3dc origin, Vector3dc direction) {

  Vector3d at(double distance) {
    return new Vector3d(origin).fma(distance, direction);
  }

  /** Where it meets the plane through a point with that normal; empty behind it and along it. */
  Optional<Vector3d> onPlane(Vector3dc point, Vector3dc normal) {
    double along = direction.dot(normal);
    double distance = point.sub(origin, new Vector3d()).dot(normal) / along;
    return distance >= 0 && Double.isFinite(distance)
        ? Optional.of(at(distance))
        : Optional.empty();
  }

  /**
   * Where it meets what is at a distance from the origin of the coordinates, measured along some of
   * the axes: a sphere, or a cylinder about the axis left out. Beside it, where it passes nearest.
   *
   * @param axes 1 for an axis that counts, 0 for one that does not
   * @param far whether the second of two places is meant
   */
  Vector3d atRadius(double radius, Vector3dc axes, boolean far) {
    double a = direction.mul(axes, new Vector3d()).lengthSquared();
    if (!(a > 0)) {
      return new Vector3d(origin); // Along the axis: no place is nearer than another.
    }
    double half = direction.mul(axes, new Vector3d()).dot(origin) / a;
    double rest = origin.mul(axes, new Vector3d()).lengthSquared() - radius * radius;
    double root = half * half - rest / a;
    double distance = root > 0 ? -half + (far ? 1 : -1) * Math.sqrt(root) : -half;
    return at(Math.max(0, distance));
  }
}
