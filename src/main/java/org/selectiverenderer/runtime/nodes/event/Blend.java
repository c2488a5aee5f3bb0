package org.selectiverenderer.runtime.nodes.event;

import org.joml.Quaterniond;
import org.selectiverenderer.runtime.scene.Rotations;

/** How an interpolator goes from one tuple of its key values to the next. */
@FunctionalInterface
public interface Blend {
  /**
   * Writes the tuple that lies a part of the way between two.
   *
   * @param values the key values
   * @param from where the one tuple begins
   * @param to where the other begins
   * @param part above 0, below 1
   * @param into is written from {@code at}
   */
  void between(float[] values, int from, int to, float part, float[] into, int at);

  /** Each of a number of components for itself. */
  static Blend linear(int components) {
    return (values, from, to, part, into, at) -> {
      for (int i = 0; i < components; i++) {
        into[at + i] = values[from + i] + part * (values[to + i] - values[from + i]);
      }
    };
  }

  /** Rotations: the short way on the unit sphere of quaternions (X3D 4.0, 19.4.6). */
  static Blend rotation() {
    Quaterniond a = new Quaterniond();
    Quaterniond b = new Quaterniond();
    float[] tuple = new float[4];
    return (values, from, to, part, into, at) -> {
      Rotations.read(values, from, a).slerp(Rotations.read(values, to, b), part);
      Rotations.write(a, tuple);
      System.arraycopy(tuple, 0, into, at, 4);
    };
  }

  /** Unit vectors: along the great circle (X3D 4.0, 19.4.5). Opposite ones have none: the first. */
  static Blend normal() {
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

  /** Colours: linearly in hue, saturation and value, the short way round (X3D 4.0, 19.4.1). */
  static Blend hsv() {
    float[] a = new float[3];
    float[] b = new float[3];
    return (values, from, to, part, into, at) -> {
      Hsv.of(values, from, a);
      Hsv.of(values, to, b);
      if (a[1] == 0) {
        a[0] = b[0]; // Grey has no hue of its own.
      } else if (b[1] == 0) {
        b[0] = a[0];
      }
      float turn = b[0] - a[0];
      float way = turn > 3 ? turn - 6 : turn < -3 ? turn + 6 : turn;
      Hsv.rgb(
          a[0] + part * way, a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2]), into, at);
    };
  }
}
