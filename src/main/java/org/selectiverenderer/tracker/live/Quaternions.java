package org.selectiverenderer.tracker.live;

import org.joml.Quaterniond;

/** Quaternion functions that JOML lacks. */
final class Quaternions {
  private Quaternions() {}

  /** Returns the angle of the rotation from one orientation to another, 0 to pi. */
  static double angle(Quaterniond from, Quaterniond to) {
    // By the distance of the quaternions: exact for small angles, where an arc cosine is not.
    double sign = from.dot(to) < 0 ? -1 : 1;
    double dx = sign * to.x - from.x;
    double dy = sign * to.y - from.y;
    double dz = sign * to.z - from.z;
    double dw = sign * to.w - from.w;
    double chord = Math.sqrt(dx * dx + dy * dy + dz * dz + dw * dw);
    return 4 * Math.asin(Math.min(1, chord / 2));
  }
}
