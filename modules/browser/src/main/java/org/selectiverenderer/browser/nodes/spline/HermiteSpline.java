package org.selectiverenderer.browser.nodes.spline;

import java.util.Arrays;

/**
 * A cubic Hermite spline through key values (X3D 4.0, 19.2.3). Missing velocities are those of a
 * Catmull-Rom spline, 0 at open ends. Velocities are adjusted for unequal key distances, so that
 * these change neither the path nor the continuity of the speed.
 */
final class HermiteSpline {
  private final float[] keys;
  private final float[] values;
  private final int components;
  private final int count;
  private final boolean closed;

  /**
   * @param count the number of keys with a complete value, at least 1
   * @param closed whether the spline is closed; only possible if the first and last value are equal
   */
  HermiteSpline(float[] keys, float[] values, int components, int count, boolean closed) {
    this.keys = keys;
    this.values = values;
    this.components = components;
    this.count = count;
    int last = (count - 1) * components;
    this.closed =
        closed
            && count > 2
            && Arrays.equals(values, 0, components, values, last, last + components);
  }

  /**
   * Returns the value between two keys.
   *
   * @param low the index of the key before
   * @param part the position between that key and the next, 0 to 1
   * @param given the velocities, for each key, for the first and last only, or none
   * @param normalize whether given velocities are scaled to the length of the whole path
   */
  float[] between(int low, double part, float[] given, boolean normalize) {
    double s = part;
    double h00 = (2 * s - 3) * s * s + 1;
    double h10 = ((s - 2) * s + 1) * s;
    double h01 = (3 - 2 * s) * s * s;
    double h11 = (s - 1) * s * s;
    double[] from = velocity(low, given, normalize);
    double[] to = velocity(low + 1, given, normalize);
    double after = 1;
    double before = 1;
    if (low > 0 || closed) {
      after = 2 * gap(low) / (gap(low) + gap(low - 1));
    }
    if (low + 2 < count || closed) {
      before = 2 * gap(low) / (gap(low) + gap(low + 1));
    }
    float[] out = new float[components];
    for (int c = 0; c < components; c++) {
      out[c] =
          (float)
              (h00 * values[low * components + c]
                  + h01 * values[(low + 1) * components + c]
                  + h10 * after * from[c]
                  + h11 * before * to[c]);
    }
    return out;
  }

  /** Returns the distance from a key to the next, wrapping around in a closed spline. */
  private double gap(int key) {
    int at = Math.floorMod(key, count - 1);
    return (double) keys[at + 1] - keys[at];
  }

  private double[] velocity(int key, float[] given, boolean normalize) {
    double[] out = new double[components];
    int from = -1;
    if (given.length >= count * components) {
      from = key;
    } else if (given.length == 2 * components && (key == 0 || key == count - 1)) {
      from = key == 0 ? 0 : 1;
    }
    if (from >= 0) {
      double square = 0;
      for (int c = 0; c < components; c++) {
        out[c] = given[from * components + c];
        square += out[c] * out[c];
      }
      if (normalize && square > 0) {
        double scale = length() / Math.sqrt(square);
        for (int c = 0; c < components; c++) {
          out[c] *= scale;
        }
      }
      return out;
    }
    boolean end = key == 0 || key == count - 1;
    if (end && !closed) {
      return out;
    }
    int before = end ? count - 2 : key - 1;
    int after = end ? 1 : key + 1;
    for (int c = 0; c < components; c++) {
      out[c] = (values[after * components + c] - values[before * components + c]) / 2;
    }
    return out;
  }

  private double length() {
    double sum = 0;
    for (int key = 0; key + 1 < count; key++) {
      double square = 0;
      for (int c = 0; c < components; c++) {
        double step = values[(key + 1) * components + c] - values[key * components + c];
        square += step * step;
      }
      sum += Math.sqrt(square);
    }
    return sum;
  }
}
