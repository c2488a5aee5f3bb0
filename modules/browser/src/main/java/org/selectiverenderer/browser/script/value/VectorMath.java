package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

/** The computations of vector, rotation and colour methods on their components. */
final class VectorMath {
  private VectorMath() {}

  static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < Math.min(a.length, b.length); i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  static double length(double[] a) {
    return Math.sqrt(dot(a, a));
  }

  /** Returns the unit vector; a zero vector stays as it is. */
  static double[] normalized(double[] a) {
    double length = length(a);
    double[] result = a.clone();
    for (int i = 0; length > 0 && i < a.length; i++) {
      result[i] /= length;
    }
    return result;
  }

  static double[] cross(double[] a, double[] b) {
    double[] c = Arrays.copyOf(b, Math.max(3, b.length));
    return new double[] {
      a[1] * c[2] - a[2] * c[1], a[2] * c[0] - a[0] * c[2], a[0] * c[1] - a[1] * c[0]
    };
  }

  static double[] append(double[] a, double last) {
    double[] result = Arrays.copyOf(a, a.length + 1);
    result[a.length] = last;
    return result;
  }

  static double[] rotation(double[] axis, double angle) {
    double[] three = Arrays.copyOf(axis, 3);
    return append(three, angle);
  }

  /** Converts axis and angle to a quaternion; the identity for a zero axis. */
  static Quaterniond quaternion(double[] r) {
    double length = Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    return length > 0
        ? new Quaterniond().fromAxisAngleRad(r[0] / length, r[1] / length, r[2] / length, r[3])
        : new Quaterniond();
  }

  /**
   * Converts a quaternion to axis and angle, the angle from 0 to pi; the identity has the Z axis.
   */
  static double[] axisAngle(Quaterniondc q) {
    double sign = q.w() < 0 ? -1 : 1;
    double sine = Math.sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
    if (sine < 1e-12) {
      return new double[] {0, 0, 1, 0};
    }
    return new double[] {
      sign * q.x() / sine,
      sign * q.y() / sine,
      sign * q.z() / sine,
      2 * Math.atan2(sine, Math.abs(q.w()))
    };
  }

  /** Returns the rotation that takes one direction to another. */
  static double[] between(double[] from, double[] to) {
    double[] a = normalized(Arrays.copyOf(from, 3));
    double[] b = normalized(Arrays.copyOf(to, 3));
    return axisAngle(new Quaterniond().rotationTo(a[0], a[1], a[2], b[0], b[1], b[2]));
  }

  static double[] inverse(double[] r) {
    return new double[] {r[0], r[1], r[2], -r[3]};
  }

  /** Returns the product of two rotations as quaternions: the second one is applied first. */
  static double[] product(double[] a, double[] b) {
    return axisAngle(quaternion(a).mul(quaternion(b)));
  }

  static double[] turned(double[] rotation, double[] v) {
    Vector3d turned = quaternion(rotation).transform(new Vector3d(v[0], v[1], v[2]));
    return new double[] {turned.x, turned.y, turned.z};
  }

  static double[] slerp(double[] from, double[] to, double t) {
    return axisAngle(quaternion(from).slerp(quaternion(to), t));
  }

  /** Converts hue 0..360, saturation and value 0..1 to red, green and blue. */
  static double[] rgb(double hue, double saturation, double value) {
    double sector = ((hue % 360 + 360) % 360) / 60;
    int i = (int) sector;
    double f = sector - i;
    double p = value * (1 - saturation);
    double q = value * (1 - saturation * f);
    double t = value * (1 - saturation * (1 - f));
    return switch (i) {
      case 0 -> new double[] {value, t, p};
      case 1 -> new double[] {q, value, p};
      case 2 -> new double[] {p, value, t};
      case 3 -> new double[] {p, q, value};
      case 4 -> new double[] {t, p, value};
      default -> new double[] {value, p, q};
    };
  }

  /** Returns hue 0..360, saturation and value 0..1 of a colour; grey has hue 0. */
  static double[] hsv(double r, double g, double b) {
    double max = Math.max(r, Math.max(g, b));
    double delta = max - Math.min(r, Math.min(g, b));
    double hue =
        delta == 0
            ? 0
            : max == r ? (g - b) / delta : max == g ? 2 + (b - r) / delta : 4 + (r - g) / delta;
    return new double[] {(hue * 60 + 360) % 360, max == 0 ? 0 : delta / max, max};
  }
}
