package org.selectiverenderer.geometry.nurbs;

import java.util.TreeSet;

/**
 * The B-spline basis functions over a knot vector. Immutable.
 *
 * @param degree the order minus 1, at least 1
 * @param knots the knot vector, non-decreasing, with {@code count + degree + 1} knots
 * @param count the number of control points, at least the order
 */
public record BSplineBasis(int degree, double[] knots, int count) {
  /** The highest order supported; models use 2 to 6. */
  public static final int MAX_ORDER = 32;

  /** Returns whether a knot vector is valid for an order and a number of control points. */
  public static boolean fits(int order, double[] knots, int count) {
    if (knots.length != order + count) {
      return false;
    }
    for (int i = 0; i < knots.length; i++) {
      if (!Double.isFinite(knots[i]) || i > 0 && knots[i] < knots[i - 1]) {
        return false;
      }
    }
    return knots[order - 1] < knots[count];
  }

  /** Returns the basis over a knot vector that {@link #fits}. */
  public static BSplineBasis of(int order, double[] knots, int count) {
    return new BSplineBasis(order - 1, knots, count);
  }

  /** Returns the basis over a clamped uniform knot vector, its end knots {@code order}-fold. */
  public static BSplineBasis uniform(int order, int count) {
    double[] knots = new double[order + count];
    for (int i = 0; i < knots.length; i++) {
      knots[i] = Math.max(0, Math.min(i - order + 1, count - order + 1));
    }
    return new BSplineBasis(order - 1, knots, count);
  }

  /** Returns the basis over an unclamped uniform knot vector, for smoothly closed curves. */
  public static BSplineBasis periodic(int order, int count) {
    double[] knots = new double[order + count];
    for (int i = 0; i < knots.length; i++) {
      knots[i] = i;
    }
    return new BSplineBasis(order - 1, knots, count);
  }

  /** Returns the least parameter. */
  public double from() {
    return knots[degree];
  }

  /** Returns the greatest parameter. */
  public double to() {
    return knots[count];
  }

  /** Returns the parameter at a fraction, 0 to 1, of the parameter range. */
  public double at(double part) {
    return from() + Math.max(0, Math.min(part, 1)) * (to() - from());
  }

  /**
   * Returns ascending parameters that divide the range evenly, and in addition the knots of
   * multiplicity {@code degree}, at which the curve may have a corner.
   *
   * @param parts the number of intervals, at least 1
   */
  public double[] parameters(int parts) {
    TreeSet<Double> all = new TreeSet<>();
    for (int i = 0; i <= parts; i++) {
      all.add(at((double) i / parts));
    }
    double near = 1e-6 * (to() - from()) / parts;
    for (int i = degree + 1; i < count; i++) {
      boolean corner = knots[i] == knots[i + degree - 1] && knots[i] > from() && knots[i] < to();
      if (corner && all.subSet(knots[i] - near, knots[i] + near).isEmpty()) {
        all.add(knots[i]);
      }
    }
    return all.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Returns the first of the {@code degree + 1} control points that affect a parameter. */
  int first(double u) {
    int low = degree;
    int high = count - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (knots[middle] <= u) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    while (low > degree && knots[low] == knots[low + 1]) {
      low--; // at the end of the last non-empty knot span
    }
    return low - degree;
  }

  /**
   * Computes the basis functions from {@link #first} on, and their derivatives (The NURBS Book,
   * algorithm A2.2 and equation 2.7).
   *
   * @param values receives the {@code degree + 1} values
   * @param slopes receives the {@code degree + 1} derivatives
   */
  void evaluate(double u, int first, double[] values, double[] slopes) {
    int span = first + degree;
    double[] left = new double[degree + 1];
    double[] right = new double[degree + 1];
    double[] lower = new double[degree];
    values[0] = 1;
    for (int j = 1; j <= degree; j++) {
      if (j == degree) {
        System.arraycopy(values, 0, lower, 0, degree);
      }
      left[j] = u - knots[span + 1 - j];
      right[j] = knots[span + j] - u;
      double saved = 0;
      for (int r = 0; r < j; r++) {
        double part = values[r] / (right[r + 1] + left[j - r]);
        values[r] = saved + right[r + 1] * part;
        saved = left[j - r] * part;
      }
      values[j] = saved;
    }
    for (int j = 0; j <= degree; j++) {
      double before = j == 0 ? 0 : slope(lower[j - 1], first + j);
      double after = j == degree ? 0 : slope(lower[j], first + j + 1);
      slopes[j] = degree * (before - after);
    }
  }

  private double slope(double value, int knot) {
    double width = knots[knot + degree] - knots[knot];
    return width > 0 ? value / width : 0;
  }
}
