package org.selectiverenderer.browser.nodes.spline;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Spherical cubic interpolation of orientations (X3D 4.0, 19.4.12; K. Shoemake, Quaternion calculus
 * and fast animation, SIGGRAPH 1987 course notes 10).
 */
final class SquadInterpolation {
  private SquadInterpolation() {}

  /**
   * @param all the unit quaternions, at least 2
   * @param low the index of the quaternion before
   * @param part the position between that quaternion and the next, 0 to 1
   */
  static Quaterniond between(Quaterniond[] all, int low, double part) {
    Quaterniond from = all[low];
    Quaterniond to = near(from, all[low + 1]);
    Quaterniond before = near(from, all[Math.max(0, low - 1)]);
    Quaterniond after = near(to, all[Math.min(all.length - 1, low + 2)]);
    Quaterniond leaving = control(before, from, to);
    Quaterniond arriving = near(leaving, control(from, to, after));
    Quaterniond outer = from.slerp(to, part, new Quaterniond());
    Quaterniond inner = leaving.slerp(arriving, part, new Quaterniond());
    return outer.slerp(inner, 2 * part * (1 - part));
  }

  /** Returns the same orientation in the hemisphere of another quaternion. */
  private static Quaterniond near(Quaterniond of, Quaterniond q) {
    return of.dot(q) < 0 ? new Quaterniond(-q.x, -q.y, -q.z, -q.w) : q;
  }

  private static Quaterniond control(Quaterniond before, Quaterniond at, Quaterniond after) {
    Quaterniond back = at.conjugate(new Quaterniond());
    Vector3d sum =
        log(back.mul(after, new Quaterniond())).add(log(back.mul(before, new Quaterniond())));
    return at.mul(exp(sum.mul(-0.25)), new Quaterniond());
  }

  private static Vector3d log(Quaterniond q) {
    double sine = Vector3d.length(q.x, q.y, q.z);
    double scale = sine < 1e-12 ? 1 : Math.atan2(sine, q.w) / sine;
    return new Vector3d(q.x, q.y, q.z).mul(scale);
  }

  private static Quaterniond exp(Vector3d v) {
    double angle = v.length();
    double scale = angle < 1e-12 ? 1 : Math.sin(angle) / angle;
    return new Quaterniond(v.x * scale, v.y * scale, v.z * scale, Math.cos(angle));
  }
}
