package org.selectiverenderer.statistics.bayes;

import java.util.function.DoubleUnaryOperator;

/**
 * Computes the logarithm of the integral of exp(f) over the real line for an f with one maximum, by
 * the trapezoidal rule from the maximum to both sides, whose error falls faster than any power of
 * the step.
 */
final class LogIntegrator {
  private static final double NEGLIGIBLE = 26;
  private static final double SMALLEST = 1e-5;
  private static final double LARGEST_STEP = 0.4;
  private static final int MOST = 4000;

  private final DoubleUnaryOperator f;

  /** The argument of the maximum; the next search for it begins there. */
  private double peak;

  LogIntegrator(DoubleUnaryOperator f, double start) {
    this.f = f;
    peak = start;
  }

  /** Returns the argument at which f was found largest. */
  double peak() {
    return peak;
  }

  double value() {
    climb();
    double top = f.applyAsDouble(peak);
    double step = step(top);
    double sum = 1;
    for (int side = -1; side <= 1; side += 2) {
      for (int i = 1; i < MOST; i++) {
        double depth = f.applyAsDouble(peak + side * i * step) - top;
        sum += Math.exp(depth);
        if (depth < -NEGLIGIBLE) {
          break;
        }
      }
    }
    return top + Math.log(sum * step);
  }

  private void climb() {
    double at = f.applyAsDouble(peak);
    double step = 0.5;
    for (int i = 0; i < MOST && step > 0.1; i++) {
      double right = f.applyAsDouble(peak + step);
      double left = right > at ? Double.NEGATIVE_INFINITY : f.applyAsDouble(peak - step);
      if (right > at) {
        peak += step;
        at = right;
      } else if (left > at) {
        peak -= step;
        at = left;
      } else {
        step /= 4;
      }
    }
  }

  /**
   * Returns 0.8 standard deviations of the normal distribution with the curvature of the maximum.
   */
  private double step(double top) {
    double width = 0.05;
    double curvature =
        (2 * top - f.applyAsDouble(peak + width) - f.applyAsDouble(peak - width)) / (width * width);
    return Math.min(LARGEST_STEP, 0.8 / Math.sqrt(Math.max(curvature, SMALLEST)));
  }
}
