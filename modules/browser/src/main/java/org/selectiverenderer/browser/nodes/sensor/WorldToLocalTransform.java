package org.selectiverenderer.browser.nodes.sensor;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Transforms points and directions from the world to the local coordinates of one instance of a
 * node, for any affine matrix. The inverse is computed only when the matrix has changed.
 */
final class WorldToLocalTransform {
  /** Volume spanned by the normalised axes below which they lie in a plane, up to rounding. */
  private static final double FLAT = 1e-13;

  /** The same volume below which rounding errors may displace a point far in local coordinates. */
  private static final double UNSURE = 1e-4;

  /** Margin for rounding, relative to the coordinates. */
  private static final double ROOM = 1e-9;

  private final Matrix4d place = new Matrix4d();
  private final Matrix4d inverse = new Matrix4d();
  private boolean invertible = true;

  /**
   * Sets the matrix of the instance.
   *
   * @return whether the matrix is invertible: false if it scales an axis to 0
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

  /** Returns the volume that the normalised axes span; NaN if an axis has no length. */
  private static double volume(Matrix4dc m) {
    double lengths =
        Vector3d.length(m.m00(), m.m01(), m.m02())
            * Vector3d.length(m.m10(), m.m11(), m.m12())
            * Vector3d.length(m.m20(), m.m21(), m.m22());
    return Math.abs(m.determinant3x3()) / lengths;
  }

  /**
   * Extends a world-space bounding box by a local box, with a margin such that {@link #point} maps
   * no point outside the former to one inside the latter.
   *
   * @param box min x, y, z, max x, y, z; infinite if the rounding error is unknown
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
