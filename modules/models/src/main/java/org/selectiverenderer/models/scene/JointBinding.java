package org.selectiverenderer.models.scene;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The pose of a joint and of its parent in which the skin was bound to them, in the coordinates of
 * the figure. An HAnimJoint turns about its centre, and leaves the skin as it is unless it is
 * turned or moved (X3D 4.0, 26.3.3); a joint of other formats is a place of its own. Where the
 * joint is {@code L} in its parent, and was bound at {@code b} with its parent at {@code p}, the
 * HAnimJoint has the matrix {@code p L b⁻¹}. Its translation and rotation follow linearly from
 * those of {@code L}, so that it moves alike between two keys too.
 *
 * @param parentPosition the origin of the parent
 * @param parentRotation its rotation
 * @param parentScale its scale, the same along all axes
 * @param position the origin of the joint, the centre of the HAnimJoint
 * @param rotation its rotation, the scaleOrientation of the HAnimJoint
 * @param scale its scale
 */
record JointBinding(
    Vector3d parentPosition,
    Quaterniond parentRotation,
    double parentScale,
    Vector3d position,
    Quaterniond rotation,
    double scale) {

  /** The binding of what is no joint, whose fields are those of the model's node. */
  static final JointBinding NONE =
      new JointBinding(new Vector3d(), new Quaterniond(), 1, new Vector3d(), new Quaterniond(), 1);

  /** Returns the translation field for a translation of the model's node. */
  double[] translation(double x, double y, double z) {
    Vector3d moved = new Vector3d(x, y, z).mul(parentScale);
    parentRotation.transform(moved).add(parentPosition).sub(position);
    return new double[] {moved.x, moved.y, moved.z};
  }

  /** Returns the rotation field, axis and angle, for a unit quaternion of the model's node. */
  double[] rotation(double x, double y, double z, double w) {
    Quaterniond turned =
        new Quaterniond(parentRotation)
            .mul(new Quaterniond(x, y, z, w))
            .mul(new Quaterniond(rotation).conjugate())
            .normalize();
    return Numbers.axisAngle(new double[] {turned.x, turned.y, turned.z, turned.w});
  }

  /** Returns the scale field for a scale of the model's node. */
  double[] scale(double x, double y, double z) {
    double by = parentScale / scale;
    return new double[] {x * by, y * by, z * by};
  }
}
