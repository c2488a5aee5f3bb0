package org.selectiverenderer.enricher.preview;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.CameraFraming;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * An orbit camera: turns about a pivot, pans and zooms. World coordinates, Y up; it looks along the
 * -Z axis of its own frame, and turning never rolls it.
 */
final class OrbitCamera {
  /** Least angle between line of sight and vertical, in radians. */
  private static final double POLE = Math.toRadians(1);

  private static final double NEARER_PER_NOTCH = 0.85;

  private final Vector3d position = new Vector3d(0, 0, 10);
  private final Quaterniond orientation = new Quaterniond();
  private final Vector3d pivot = new Vector3d();
  private double fieldOfView = Math.PI / 4;

  Pose pose() {
    return new Pose(position, orientation, fieldOfView);
  }

  /**
   * Sets the camera's pose.
   *
   * @param distance distance in metres of the pivot, straight ahead
   */
  void place(Pose pose, double distance) {
    position.set(pose.position());
    orientation.set(pose.orientation());
    fieldOfView = pose.fieldOfView();
    position.fma(distance, forward(), pivot);
  }

  /** Sets the pivot. */
  void pivot(Vector3dc point) {
    pivot.set(point);
  }

  private Vector3d forward() {
    return orientation.transform(new Vector3d(0, 0, -1));
  }

  /**
   * Turns about the pivot.
   *
   * @param yaw radians about the world's Y axis
   * @param pitch radians up
   */
  void turn(double yaw, double pitch) {
    double elevation = Math.asin(Math.max(-1, Math.min(1, forward().y)));
    double most = Math.PI / 2 - POLE;
    double tilt = Math.max(-most, Math.min(most, elevation + pitch)) - elevation;
    Vector3d right = orientation.transform(new Vector3d(1, 0, 0));
    Quaterniond turn = new Quaterniond().rotationY(yaw).rotateAxis(tilt, right.x, right.y, right.z);
    turn.transform(position.sub(pivot)).add(pivot);
    turn.mul(orientation, orientation).normalize();
  }

  /**
   * Pans camera and pivot.
   *
   * @param right shift as a share of the picture's smaller side, at the distance of the pivot
   * @param up shift upwards, in the same unit
   */
  void pan(double right, double up) {
    double unit = 2 * Math.tan(fieldOfView / 2) * position.distance(pivot);
    Vector3d shift = orientation.transform(new Vector3d(right * unit, up * unit, 0));
    position.add(shift);
    pivot.add(shift);
  }

  /** Zooms towards the pivot, by 15 % of the distance per notch of the wheel. */
  void zoom(double notches) {
    position.sub(pivot).mul(Math.pow(NEARER_PER_NOTCH, notches)).add(pivot);
  }

  /** Frames a box, keeping the present direction. */
  void frame(BoundingBox box) {
    pivot.set(box.min()).add(box.max()).mul(0.5);
    pivot.fma(-CameraFraming.distance(box, orientation, fieldOfView), forward(), position);
  }

  /** Sets the orientation. */
  void face(Quaterniondc direction) {
    orientation.set(direction);
  }

  /**
   * Sets the direction.
   *
   * @param yaw radians to the left of -Z
   * @param pitch radians up
   */
  void face(double yaw, double pitch) {
    orientation.rotationYXZ(yaw, pitch, 0);
  }
}
