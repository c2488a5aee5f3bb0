package org.selectiverenderer.runtime.nodes.sensor;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Takes points and directions of the world into the local coordinates of one place of a node, under
 * any affine transformation. The inverse is made when the place is another one, not every frame.
 */
final class LocalFrame {
  /** Volume of the unit-length axes below which they lie in a plane, but for rounding. */
  private static final double FLAT = 1e-13;

  private final Matrix4d place = new Matrix4d();
  private final Matrix4d inverse = new Matrix4d();
  private boolean invertible = true;

  /**
   * Follows the place.
   *
   * @return whether it has local coordinates: false where a transformation above flattens it
   */
  boolean follow(Matrix4dc now) {
    if (!place.equals(now)) {
      place.set(now);
      invertible = !flat(now) && now.invert(inverse).isFinite();
    }
    return invertible;
  }

  private static boolean flat(Matrix4dc m) {
    double lengths =
        Vector3d.length(m.m00(), m.m01(), m.m02())
            * Vector3d.length(m.m10(), m.m11(), m.m12())
            * Vector3d.length(m.m20(), m.m21(), m.m22());
    return !(Math.abs(m.determinant3x3()) > FLAT * lengths);
  }

  Vector3d point(Vector3dc world, Vector3d into) {
    return inverse.transformPosition(world, into);
  }

  Vector3d direction(Vector3dc world, Vector3d into) {
    return inverse.transformDirection(world, into);
  }
}
