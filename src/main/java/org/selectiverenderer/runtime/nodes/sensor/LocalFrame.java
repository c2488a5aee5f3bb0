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

  /** The same volume below which rounding may take a point far away in local coordinates. */
  private static final double UNSURE = 1e-4;

  /** Room for rounding, as a share of the coordinates. */
  private static final double ROOM = 1e-9;

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
    return !(volume(m) > FLAT);
  }

  /** The volume that the axes would span if each had length 1; NaN where one has none. */
  private static double volume(Matrix4dc m) {
    double lengths =
        Vector3d.length(m.m00(), m.m01(), m.m02())
            * Vector3d.length(m.m10(), m.m11(), m.m12())
            * Vector3d.length(m.m20(), m.m21(), m.m22());
    return Math.abs(m.determinant3x3()) / lengths;
  }

  /**
   * Lets a box of the world enclose a local box too, with so much room that {@link #point} takes no
   * point outside to one inside.
   *
   * @param box min x, y, z, max x, y, z; without bounds where rounding cannot be told
   */
  static void enclose(Matrix4dc place, float[] center, float[] size, double[] box) {
    double reach = 0;
    for (int axis = 0; axis < 3; axis++) {
      double middle = place.getRowColumn(axis, 3);
      double half = 0;
      for (int from = 0; from < 3; from++) {
        middle += place.getRowColumn(axis, from) * center[from];
        half += Math.abs(place.getRowColumn(axis, from)) * size[from] / 2;
        reach += Math.abs(place.getRowColumn(axis, from)) * (Math.abs(center[from]) + size[from]);
      }
      reach += Math.abs(place.getRowColumn(axis, 3));
      box[axis] = Math.min(box[axis], middle - half);
      box[axis + 3] = Math.max(box[axis + 3], middle + half);
    }
    double room = volume(place) > UNSURE && place.isAffine() ? ROOM * reach : Double.NaN;
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = Double.isFinite(room) ? box[axis] - room : Double.NEGATIVE_INFINITY;
      box[axis + 3] = Double.isFinite(room) ? box[axis + 3] + room : Double.POSITIVE_INFINITY;
    }
  }

  Vector3d point(Vector3dc world, Vector3d into) {
    return inverse.transformPosition(world, into);
  }

  Vector3d direction(Vector3dc world, Vector3d into) {
    return inverse.transformDirection(world, into);
  }
}
