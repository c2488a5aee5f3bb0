package org.selectiverenderer.statistics.bayes;

import java.util.List;
import java.util.Random;
import org.apache.commons.math3.random.HaltonSequenceGenerator;

/**
 * Importance sampling for the integral over the g of three or more terms. Points of a Halton
 * sequence are drawn from logistic distributions around the integrand's mode and shifted at random
 * for each batch (Owen 1998, Monte Carlo extension of quasi-Monte Carlo), so that the spread of the
 * batches estimates the integration error.
 */
final class ImportanceSampler {
  /** Number of batches, whose spread estimates the integration error. */
  static final int BATCHES = 8;

  private static final int POINTS = 1000;

  /**
   * The scale of the logistic proposal, in standard deviations of the mode; above 1 so that its
   * tails are wider than the integrand's.
   */
  private static final double WIDER = 1.2;

  private final NonorthogonalTermBlock component;
  private final List<TermDesignMatrix> terms;
  private final VarianceEstimates scale;
  private final double r;

  ImportanceSampler(
      NonorthogonalTermBlock component,
      List<TermDesignMatrix> terms,
      VarianceEstimates scale,
      double r) {
    this.component = component;
    this.terms = terms;
    this.scale = scale;
    this.r = r;
  }

  /** Returns the points of a batch. */
  QuadratureGrid nodes(long seed, int batch) {
    int size = terms.size();
    double[] peak = peak();
    double[] widths = new double[size];
    for (int t = 0; t < size; t++) {
      widths[t] = WIDER * width(peak, t);
    }
    Random random = new Random(seed * BATCHES + batch);
    double[] shift = random.doubles(size).toArray();
    HaltonSequenceGenerator sequence = new HaltonSequenceGenerator(size);
    double[][] points = new double[POINTS][size];
    double[] weights = new double[POINTS];
    for (int i = 0; i < POINTS; i++) {
      double[] uniform = sequence.nextVector();
      weights[i] = -Math.log(POINTS);
      for (int t = 0; t < size; t++) {
        double u = Math.min(1 - 1e-12, Math.max(1e-12, (uniform[t] + shift[t]) % 1));
        points[i][t] = peak[t] + widths[t] * Math.log(u / (1 - u));
        weights[i] += Math.log(widths[t] / (u * (1 - u))); // reciprocal of the logistic density
      }
    }
    return QuadratureGrid.of(component, terms, points, weights);
  }

  /** Returns the logarithm of the integrand, with the error variance at its estimate. */
  private double log(double[] logG) {
    double[] found = component.at(terms, logG);
    double log =
        -component.width() * found[0] / 2 - found[1] / (2 * scale.variance() * scale.average());
    for (double g : logG) {
      log += InverseGammaPrior.logDensity(g + Math.log(scale.average()), r);
    }
    return log;
  }

  private double[] peak() {
    double[] peak = new double[terms.size()];
    for (int t = 0; t < peak.length; t++) {
      peak[t] = Math.log(r * r / scale.average());
    }
    double best = log(peak);
    for (double step = 1; step > 0.1; step /= 2) {
      boolean better = true;
      while (better) {
        better = false;
        for (int t = 0; t < peak.length; t++) {
          for (int side = -1; side <= 1; side += 2) {
            double[] next = peak.clone();
            next[t] += side * step;
            double value = log(next);
            if (value > best) {
              best = value;
              peak = next;
              better = true;
            }
          }
        }
      }
    }
    return peak;
  }

  private double width(double[] peak, int t) {
    double apart = 0.3;
    double[] low = peak.clone();
    double[] high = peak.clone();
    low[t] -= apart;
    high[t] += apart;
    double curvature = (2 * log(peak) - log(low) - log(high)) / (apart * apart);
    return Math.min(2, 1 / Math.sqrt(Math.max(0.1, curvature)));
  }
}
