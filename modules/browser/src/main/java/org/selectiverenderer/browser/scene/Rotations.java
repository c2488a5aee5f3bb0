package org.selectiverenderer.browser.scene;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Converts between SFRotation values (axis and angle in radians) and quaternions. */
public final class Rotations {
  private Rotations() {}

  /** Reads the rotation of four floats at an offset; the identity for an axis without length. */
  public static Quaterniond read(float[] values, int offset, Quaterniond into) {
    double x = values[offset];
    double y = values[offset + 1];
    double z = values[offset + 2];
    double length = Math.sqrt(x * x + y * y + z * z);
    return length > 0
        ? into.fromAxisAngleRad(x / length, y / length, z / length, values[offset + 3])
        : into.identity();
  }

  /**
   * Writes axis and angle, the angle in 0..pi; the identity is written as an angle of 0 about Z.
   */
  public static void write(Quaterniondc rotation, float[] into) {
    double sign = rotation.w() < 0 ? -1 : 1;
    double x = sign * rotation.x();
    double y = sign * rotation.y();
    double z = sign * rotation.z();
    double sine = Math.sqrt(x * x + y * y + z * z);
    if (sine < 1e-12) {
      into[0] = 0;
      into[1] = 0;
      into[2] = 1;
      into[3] = 0;
      return;
    }
    into[0] = (float) (x / sine);
    into[1] = (float) (y / sine);
    into[2] = (float) (z / sine);
    into[3] = (float) (2 * Math.atan2(sine, Math.abs(rotation.w())));
  }

  /**
   * Returns the orientation that looks along a direction with its up as near as possible to a given
   * one; the identity if both are parallel.
   *
   * @param forward the viewing direction, of any length; {@code up} may have any length and need
   *     not be orthogonal to it
   * @param scratch a scratch matrix, overwritten
   */
  public static Quaterniond looking(
      Vector3dc forward, Vector3dc up, Matrix3d scratch, Quaterniond into) {
    double length = forward.length();
    double zx = -forward.x() / length;
    double zy = -forward.y() / length;
    double zz = -forward.z() / length;
    double xx = up.y() * zz - up.z() * zy;
    double xy = up.z() * zx - up.x() * zz;
    double xz = up.x() * zy - up.y() * zx;
    double across = Math.sqrt(xx * xx + xy * xy + xz * xz);
    if (!(length > 0) || !(across > 1e-12 * up.length())) {
      return into.identity();
    }
    xx /= across;
    xy /= across;
    xz /= across;
    scratch.set(xx, xy, xz, zy * xz - zz * xy, zz * xx - zx * xz, zx * xy - zy * xx, zx, zy, zz);
    return into.setFromNormalized(scratch).normalize();
  }

  /** Computes the viewing direction, -Z of the viewer's frame, in the world. */
  public static Vector3d forward(Quaterniondc orientation, Vector3d into) {
    return orientation.transform(into.set(0, 0, -1));
  }

  /** Computes the viewer's up, Y of its frame, in the world. */
  public static Vector3d up(Quaterniondc orientation, Vector3d into) {
    return orientation.transform(into.set(0, 1, 0));
  }
}
