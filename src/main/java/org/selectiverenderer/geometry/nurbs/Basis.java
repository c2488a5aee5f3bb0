package org.selectiverenderer.geometry.nurbs;

import java.util.TreeSet;

/**
 * The B-spline basis functions of one parameter. Immutable.
 *
 * @param degree the order less one, at least 1
 * @param knots ascending, as many as control points and order together
 * @param count control points, at least the order
 */
public record Basis(int degree, double[] knots, int count) {
  /** The highest order taken; those of models are 2 to 6. */
  public static final int MAX_ORDER = 32;

  /** Whether knots can be those of a basis. */
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

  /** The basis over knots that {@link #fits} finds fit. */
  public static Basis of(int order, double[] knots, int count) {
    return new Basis(order - 1, knots, count);
  }

  /** Knots at equal distances, the first and last {@code order} of them the same. */
  public static Basis uniform(int order, int count) {
    double[] knots = new double[order + count];
    for (int i = 0; i < knots.length; i++) {
      knots[i] = Math.max(0, Math.min(i - order + 1, count - order + 1));
    }
    return new Basis(order - 1, knots, count);
  }

  /** Knots at equal distances throughout: a curve whose last points are its first is smooth. */
  public static Basis periodic(int order, int count) {
    double[] knots = new double[order + count];
    for (int i = 0; i < knots.length; i++) {
      knots[i] = i;
    }
    return new Basis(order - 1, knots, count);
  }

  /** The least parameter. */
  public double from() {
    return knots[degree];
  }

  /** The greatest parameter. */
  public double to() {
    return knots[count];
  }

  /** The parameter at a part of the way, 0 to 1. */
  public double at(double part) {
    return from() + Math.max(0, Math.min(part, 1)) * (to() - from());
  }

  /**
   * Parameters that divide the range evenly, and besides those where the curve may have a corner,
   * ascending.
   *
   * @param parts at least 1
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

  /** The first control point that counts at a parameter; the next {@code degree} do too. */
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
      low--; // At the end of the last span that has a length.
    }
    return low - degree;
  }

  /**
   * The values of the functions from {@link #first} on, and their derivatives (The NURBS Book,
   * algorithm A2.2 and equation 2.7).
   *
   * @param values {@code degree + 1} long
   * @param slopes likewise
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
