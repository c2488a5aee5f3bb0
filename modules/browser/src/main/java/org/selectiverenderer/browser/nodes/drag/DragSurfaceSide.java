package org.selectiverenderer.browser.nodes.drag;

import org.joml.Vector3dc;

/**
 * Determines on which side of a sphere or cylinder a drag began: on the near side, seen from
 * outside, or on the far side, seen from inside.
 */
final class DragSurfaceSide {
  private DragSurfaceSide() {}

  /**
   * Returns whether a hit point is nearer to the ray's second intersection with the surface than to
   * the first.
   */
  static boolean far(DragRay ray, Vector3dc hit, double radius, Vector3dc axes) {
    return ray.atRadius(radius, axes, true).distanceSquared(hit)
        < ray.atRadius(radius, axes, false).distanceSquared(hit);
  }
}
