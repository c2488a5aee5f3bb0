package org.selectiverenderer.tracker;

import org.joml.Quaterniond;

/**
 * A pose sample: orientation of the head, position if the device measures it, and time of arrival.
 * Mutable, so that reading one allocates nothing; it belongs to the thread that made it.
 *
 * <p>Angles are in degrees about the axes of X3D's viewer, who looks along -Z with +Y up: yaw about
 * Y (positive to the left), pitch about X (positive up), roll about Z (positive tilts the head to
 * its left shoulder), composed as yaw, then pitch, then roll (order YXZ). See {@link Orientation}.
 * The position is in metres along the same axes: to the right, above and behind the origin of the
 * device.
 */
public final class PoseSample {
  private long number;
  private long arrival;
  private double yaw;
  private double pitch;
  private double roll;
  private int straightened;
  private boolean placed;
  private double x;
  private double y;
  private double z;

  /** Copies another sample. */
  public void set(PoseSample other) {
    set(other.number, other.arrival, other.yaw, other.pitch, other.roll);
    straightened = other.straightened;
    placed = other.placed;
    x = other.x;
    y = other.y;
    z = other.z;
  }

  /**
   * Sets everything except the position.
   *
   * @param number number of the record, from 1
   * @param arrival time of arrival, by {@link System#nanoTime}
   */
  public void set(long number, long arrival, double yaw, double pitch, double roll) {
    this.number = number;
    this.arrival = arrival;
    turn(yaw, pitch, roll);
  }

  /** Sets the position only, in metres. */
  public void place(double right, double up, double back) {
    placed = true;
    x = right;
    y = up;
    z = back;
  }

  /** Sets the number of boresights so far. */
  public void straightened(int times) {
    straightened = times;
  }

  /**
   * Returns the number of boresights so far: resets of the heading, and with it of the origin of
   * positions.
   */
  public int straightened() {
    return straightened;
  }

  /** Removes the position. */
  public void unplace() {
    placed = false;
  }

  /**
   * Rotates position and orientation about the vertical axis, so that a heading becomes yaw 0.
   *
   * @param ahead the heading in degrees
   */
  public void ahead(double ahead) {
    turn(yaw - ahead, pitch, roll);
    double sin = Math.sin(Math.toRadians(ahead));
    double cos = Math.cos(Math.toRadians(ahead));
    double right = cos * x - sin * z;
    z = sin * x + cos * z;
    x = right;
  }

  /** Sets the angles only, in degrees; each is normalized to -180 to 180. */
  public void turn(double yaw, double pitch, double roll) {
    this.yaw = Orientation.wrap(yaw);
    this.pitch = Orientation.wrap(pitch);
    this.roll = Orientation.wrap(roll);
  }

  /**
   * Sets the angles only, from a unit quaternion that rotates the viewer's frame to the world's.
   */
  public void turn(double x, double y, double z, double w) {
    // The third column and the second row of Ry(yaw) Rx(pitch) Rz(roll) hold the angles.
    double sin = 2 * (x * w - y * z);
    if (Math.abs(sin) < 1 - 1e-12) {
      yaw = Math.toDegrees(Math.atan2(2 * (x * z + y * w), 1 - 2 * (x * x + y * y)));
      pitch = Math.toDegrees(Math.asin(sin));
      roll = Math.toDegrees(Math.atan2(2 * (x * y + z * w), 1 - 2 * (x * x + z * z)));
    } else { // Gimbal lock: roll is 0 and yaw is the whole turn.
      yaw = Math.toDegrees(Math.atan2(-2 * (x * z - y * w), 1 - 2 * (y * y + z * z)));
      pitch = Math.copySign(90, sin);
      roll = 0;
    }
  }

  /** Returns the number of the record since the tracker was opened, from 1; 0 before the first. */
  public long number() {
    return number;
  }

  /** Returns the time of arrival, in nanoseconds of {@link System#nanoTime}. */
  public long arrival() {
    return arrival;
  }

  /** Returns the rotation about Y, -180 to 180 degrees. */
  public double yaw() {
    return yaw;
  }

  /** Returns the rotation about X, -180 to 180 degrees, beyond 90 only if the device reports it. */
  public double pitch() {
    return pitch;
  }

  /** Returns the rotation about Z, -180 to 180 degrees. */
  public double roll() {
    return roll;
  }

  /** Returns whether the sample has a position. */
  public boolean placed() {
    return placed;
  }

  /** Returns the position to the right in metres; undefined unless {@link #placed}. */
  public double x() {
    return x;
  }

  /** Returns the position upward in metres. */
  public double y() {
    return y;
  }

  /** Returns the position backward in metres. */
  public double z() {
    return z;
  }

  /** Returns the orientation as an immutable value. */
  public Orientation orientation() {
    return new Orientation(yaw, pitch, roll);
  }

  /**
   * Writes the orientation to a quaternion that rotates the viewer's frame to the world's;
   * allocates nothing.
   *
   * @return {@code into}
   */
  public Quaterniond orientation(Quaterniond into) {
    return into.rotationYXZ(Math.toRadians(yaw), Math.toRadians(pitch), Math.toRadians(roll));
  }
}
