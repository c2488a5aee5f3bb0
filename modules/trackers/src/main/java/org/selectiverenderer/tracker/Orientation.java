package org.selectiverenderer.tracker;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.RotationOrder;

/**
 * The orientation of a head as Euler angles in degrees.
 *
 * <p>The viewer of X3D looks along -Z with +Y up (X3D 4.0, 23.4.6), so that yaw turns about Y,
 * pitch about X and roll about Z. They are composed in the order YXZ: R = Ry(yaw) Rx(pitch)
 * Rz(roll), roll applied to the viewer first. The thesis's own formula (Fig 50) turns an object
 * that looks along +X; a test compares the two formulas.
 *
 * <p>{@link #rotation} is the reference implementation, by Commons Math, whose rotations are
 * immutable. {@link PoseSample}, which is used for each record, computes the same without
 * allocating; a test compares the two implementations.
 *
 * @param yaw about Y, positive to the left
 * @param pitch about X, positive up
 * @param roll about Z, positive towards the left shoulder
 */
public record Orientation(double yaw, double pitch, double roll) {
  /** Returns the rotation from the viewer's frame to the world's. */
  public Rotation rotation() {
    return new Rotation(
        RotationOrder.YXZ,
        RotationConvention.VECTOR_OPERATOR,
        Math.toRadians(yaw),
        Math.toRadians(pitch),
        Math.toRadians(roll));
  }

  /**
   * Returns the angles of a rotation; at gimbal lock (straight up or down) roll is 0 and yaw is the
   * whole turn.
   */
  public static Orientation of(Rotation rotation) {
    PoseSample sample = new PoseSample();
    // Commons Math's own angles are undefined straight up and down, and its q0 is w, with the
    // other three of opposite sign to the Hamilton convention.
    sample.turn(-rotation.getQ1(), -rotation.getQ2(), -rotation.getQ3(), rotation.getQ0());
    return sample.orientation();
  }

  /** Returns an angle normalized to -180 to 180 degrees. */
  static double wrap(double degrees) {
    return degrees >= -180 && degrees <= 180 ? degrees : Math.IEEEremainder(degrees, 360);
  }
}
