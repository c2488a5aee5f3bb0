package org.selectiverenderer.browser.nodes.event;

import org.joml.Quaterniond;
import org.selectiverenderer.browser.scene.Rotations;

/** The interpolation between two neighbouring key values. */
@FunctionalInterface
public interface KeyValueInterpolation {
  /**
   * Writes the tuple interpolated between two key values.
   *
   * @param values the key values
   * @param from the index at which the first tuple starts
   * @param to the index at which the second tuple starts
   * @param part the interpolation parameter, above 0 and below 1
   * @param into the target, written from index {@code at}
   */
  void between(float[] values, int from, int to, float part, float[] into, int at);

  /** Returns linear interpolation of each component. */
  static KeyValueInterpolation linear(int components) {
    return (values, from, to, part, into, at) -> {
      for (int i = 0; i < components; i++) {
        into[at + i] = values[from + i] + part * (values[to + i] - values[from + i]);
      }
    };
  }

  /** Returns spherical linear interpolation of rotations, the short way (X3D 4.0, 19.4.6). */
  static KeyValueInterpolation rotation() {
    Quaterniond a = new Quaterniond();
    Quaterniond b = new Quaterniond();
    float[] tuple = new float[4];
    return (values, from, to, part, into, at) -> {
      Rotations.read(values, from, a).slerp(Rotations.read(values, to, b), part);
      Rotations.write(a, tuple);
      System.arraycopy(tuple, 0, into, at, 4);
    };
  }

  /**
   * Returns interpolation of unit vectors along the great circle (X3D 4.0, 19.4.5). Between
   * opposite vectors, which have no unique great circle, it gives the first.
   */
  static KeyValueInterpolation normal() {
    return (v, from, to, part, into, at) -> {
      double dot = v[from] * v[to] + v[from + 1] * v[to + 1] + v[from + 2] * v[to + 2];
      double angle = Math.acos(Math.max(-1, Math.min(1, dot)));
      double sine = Math.sin(angle);
      double first = sine < 1e-6 ? 1 : Math.sin((1 - part) * angle) / sine;
      double second = sine < 1e-6 ? 0 : Math.sin(part * angle) / sine;
      for (int i = 0; i < 3; i++) {
        into[at + i] = (float) (first * v[from + i] + second * v[to + i]);
      }
    };
  }

  /**
   * Returns linear interpolation of colours in HSV, the short way around the hue circle (X3D 4.0,
   * 19.4.1).
   */
  static KeyValueInterpolation hsv() {
    float[] a = new float[3];
    float[] b = new float[3];
    return (values, from, to, part, into, at) -> {
      HsvColor.of(values, from, a);
      HsvColor.of(values, to, b);
      if (a[1] == 0) {
        a[0] = b[0]; // Grey has no hue of its own.
      } else if (b[1] == 0) {
        b[0] = a[0];
      }
      float turn = b[0] - a[0];
      float way = turn > 3 ? turn - 6 : turn < -3 ? turn + 6 : turn;
      HsvColor.rgb(
          a[0] + part * way, a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2]), into, at);
    };
  }
}
