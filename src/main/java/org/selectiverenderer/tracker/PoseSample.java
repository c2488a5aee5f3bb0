package org.selectiverenderer.tracker;

import org.joml.Quaterniond;

/**
 * One orientation of the head, its place if the device tells it, and when it arrived. Mutable, so
 * that reading one allocates nothing; it belongs to the thread that made it.
 *
 * <p>Angles are in degrees about the axes of X3D's viewer, who looks along -Z with +Y up: yaw about
 * Y (positive to the left), pitch about X (positive up), roll about Z (positive tilts the head to
 * its left shoulder), composed as yaw, then pitch, then roll (order YXZ). See {@link Orientation}.
 * The place is in metres along the same axes: right, up and back of where the device counts from.
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
   * Sets all of it but the place.
   *
   * @param number of the record, counted from 1
   * @param arrival as {@link System#nanoTime} told it
   */
  public void set(long number, long arrival, double yaw, double pitch, double roll) {
    this.number = number;
    this.arrival = arrival;
    turn(yaw, pitch, roll);
  }

  /** Sets the place only, in metres. */
  public void place(double right, double up, double back) {
    placed = true;
    x = right;
    y = up;
    z = back;
  }

  /** Sets how often straight ahead was set anew. */
  public void straightened(int times) {
    straightened = times;
  }

  /** How often straight ahead, and with it where places count from, was set anew. */
  public int straightened() {
    return straightened;
  }

  /** There is no place. */
  public void unplace() {
    placed = false;
  }

  /**
   * Turns place and angles about the vertical axis, so that what was at a yaw is at 0.
   *
   * @param ahead that yaw in degrees
   */
  public void ahead(double ahead) {
    turn(yaw - ahead, pitch, roll);
    double sin = Math.sin(Math.toRadians(ahead));
    double cos = Math.cos(Math.toRadians(ahead));
    double right = cos * x - sin * z;
    z = sin * x + cos * z;
    x = right;
  }

  /** Sets the angles only, in degrees; each is brought to -180 to 180. */
  public void turn(double yaw, double pitch, double roll) {
    this.yaw = Orientation.wrap(yaw);
    this.pitch = Orientation.wrap(pitch);
    this.roll = Orientation.wrap(roll);
  }

  /** Sets the angles only, from a unit quaternion that takes the viewer's frame to the world's. */
  public void turn(double x, double y, double z, double w) {
    // The third column and the second row of Ry(yaw) Rx(pitch) Rz(roll) hold the angles.
    double sin = 2 * (x * w - y * z);
    if (Math.abs(sin) < 1 - 1e-12) {
      yaw = Math.toDegrees(Math.atan2(2 * (x * z + y * w), 1 - 2 * (x * x + y * y)));
      pitch = Math.toDegrees(Math.asin(sin));
      roll = Math.toDegrees(Math.atan2(2 * (x * y + z * w), 1 - 2 * (x * x + z * z)));
    } else { // Straight up or down yaw and roll are one: all of it is told as yaw.
      yaw = Math.toDegrees(Math.atan2(-2 * (x * z - y * w), 1 - 2 * (y * y + z * z)));
      pitch = Math.copySign(90, sin);
      roll = 0;
    }
  }

  /** Which record it is, counted from 1 since the tracker was opened; 0 before the first. */
  public long number() {
    return number;
  }

  /** When the record arrived, in nanoseconds of {@link System#nanoTime}, which never goes back. */
  public long arrival() {
    return arrival;
  }

  /** About Y, -180 to 180 degrees. */
  public double yaw() {
    return yaw;
  }

  /** About X, -180 to 180 degrees, beyond 90 only if a device says so. */
  public double pitch() {
    return pitch;
  }

  /** About Z, -180 to 180 degrees. */
  public double roll() {
    return roll;
  }

  /** Whether the place is told. */
  public boolean placed() {
    return placed;
  }

  /** To the right, in metres; without meaning unless {@link #placed}. */
  public double x() {
    return x;
  }

  /** Up, in metres. */
  public double y() {
    return y;
  }

  /** Back, in metres. */
  public double z() {
    return z;
  }

  /** The angles as a value. */
  public Orientation orientation() {
    return new Orientation(yaw, pitch, roll);
  }

  /**
   * The orientation as a quaternion that takes the viewer's frame to the world's; allocates
   * nothing.
   *
   * @return {@code into}
   */
  public Quaterniond orientation(Quaterniond into) {
    return into.rotationYXZ(Math.toRadians(yaw), Math.toRadians(pitch), Math.toRadians(roll));
  }
}
