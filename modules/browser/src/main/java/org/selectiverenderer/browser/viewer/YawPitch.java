package org.selectiverenderer.browser.viewer;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

/**
 * The viewing direction of an upright viewer: yaw about the up axis, positive to the left, and
 * pitch, positive up, at most 90 degrees either way (thesis 6.1.1: 360 degrees about, 180
 * vertically). Radians.
 */
public record YawPitch(double yaw, double pitch) {
  /**
   * Vertical component of the viewing direction beyond which the viewer looks nearly straight up or
   * down, so that the yaw is taken from the right vector.
   */
  private static final double STEEP = 0.99999;

  /** Returns the heading of an orientation; its roll is dropped. */
  public static YawPitch of(Quaterniondc orientation) {
    Vector3d front = orientation.transform(new Vector3d(0, 0, -1));
    double pitch = Math.asin(Math.max(-1, Math.min(1, front.y)));
    if (Math.abs(front.y) < STEEP) {
      return new YawPitch(Math.atan2(-front.x, -front.z), pitch);
    }
    Vector3d right = orientation.transform(new Vector3d(1, 0, 0));
    return new YawPitch(Math.atan2(-right.z, right.x), pitch);
  }

  public YawPitch turned(double moreYaw, double morePitch) {
    double limit = Math.PI / 2;
    return new YawPitch(yaw + moreYaw, Math.max(-limit, Math.min(limit, pitch + morePitch)));
  }

  public Quaterniond orientation() {
    return Viewer.orientation(yaw, pitch, 0);
  }

  /** Returns the horizontal vector with the given components forward and to the right. */
  public Vector3d level(double forward, double right) {
    double sin = Math.sin(yaw);
    double cos = Math.cos(yaw);
    return new Vector3d(-sin * forward + cos * right, 0, -cos * forward - sin * right);
  }
}
