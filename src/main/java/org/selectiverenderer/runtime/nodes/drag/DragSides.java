package org.selectiverenderer.runtime.nodes.drag;

import org.joml.Vector3dc;

/** On which side of a round surface a drag began: outside on the near one, inside on the far. */
final class DragSides {
  private DragSides() {}

  /**
   * Whether a point that a ray hits is nearer to the second place at that radius than the first.
   */
  static boolean far(DragRay ray, Vector3dc hit, double radius, Vector3dc axes) {
    return ray.atRadius(radius, axes, true).distanceSquared(hit)
        < ray.atRadius(radius, axes, false).distanceSquared(hit);
  }
}
