package org.selectiverenderer.browser.nodes.follow;

import java.util.Arrays;
import org.joml.Quaterniond;
import org.selectiverenderer.browser.scene.Rotations;

/**
 * The value space of a follower: converts field values to arrays of numbers and computes
 * differences and steps between them.
 */
enum FollowerValueSpace {
  /** Numbers, vectors, colours and lists of vectors; each component is independent. */
  LINEAR {
    @Override
    double[] read(Object value) {
      if (value instanceof Float number) {
        return new double[] {number};
      }
      float[] floats = (float[]) value;
      double[] numbers = new double[floats.length];
      for (int i = 0; i < floats.length; i++) {
        numbers[i] = floats[i];
      }
      return numbers;
    }

    @Override
    Object write(double[] numbers, boolean scalar) {
      if (scalar) {
        return (float) numbers[0];
      }
      float[] floats = new float[numbers.length];
      for (int i = 0; i < floats.length; i++) {
        floats[i] = (float) numbers[i];
      }
      return floats;
    }

    @Override
    double[] way(double[] from, double[] to) {
      double[] way = new double[from.length];
      for (int i = 0; i < way.length; i++) {
        way[i] = to[i] - from[i];
      }
      return way;
    }

    @Override
    double[] along(double[] from, double[] way, double share) {
      double[] there = new double[from.length];
      for (int i = 0; i < there.length; i++) {
        there[i] = from[i] + share * way[i];
      }
      return there;
    }

    @Override
    double length(double[] way) {
      double longest = 0;
      for (double part : way) {
        longest = Math.max(longest, Math.abs(part));
      }
      return longest;
    }
  },

  /** Rotations as quaternions x, y, z, w, interpolated the short way. */
  ROTATION {
    @Override
    double[] read(Object value) {
      return numbers(Rotations.read((float[]) value, 0, new Quaterniond()));
    }

    @Override
    Object write(double[] numbers, boolean scalar) {
      float[] rotation = new float[4];
      Rotations.write(quaternion(numbers).normalize(), rotation);
      return rotation;
    }

    @Override
    double[] way(double[] from, double[] to) {
      Quaterniond way = quaternion(from).conjugate().mul(quaternion(to));
      return numbers(way.w < 0 ? way.mul(-1) : way);
    }

    @Override
    double[] along(double[] from, double[] way, double share) {
      Quaterniond part = new Quaterniond().slerp(quaternion(way), share);
      return numbers(quaternion(from).mul(part).normalize());
    }

    @Override
    double length(double[] way) {
      return 2 * Math.acos(Math.min(1, Math.abs(way[3])));
    }
  };

  private static Quaterniond quaternion(double[] numbers) {
    return new Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]);
  }

  private static double[] numbers(Quaterniond q) {
    return new double[] {q.x, q.y, q.z, q.w};
  }

  abstract double[] read(Object value);

  /**
   * Converts numbers to a field value.
   *
   * @param scalar whether the value is a single number
   */
  abstract Object write(double[] numbers, boolean scalar);

  /** Returns the difference from one value to another of the same length. */
  abstract double[] way(double[] from, double[] to);

  /** Returns the value reached after a share of a difference. */
  abstract double[] along(double[] from, double[] way, double share);

  /** Returns the length of a difference: its largest component, or an angle in radians. */
  abstract double length(double[] way);

  /** Returns numbers with the length of another value; added elements are copied from it. */
  static double[] fitted(double[] numbers, double[] other) {
    double[] fitted = Arrays.copyOf(numbers, other.length);
    if (other.length > numbers.length) {
      System.arraycopy(
          other, numbers.length, fitted, numbers.length, other.length - numbers.length);
    }
    return fitted;
  }
}
