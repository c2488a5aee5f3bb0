package org.selectiverenderer.experiment.threshold;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.experiment.threshold.ThresholdEstimate.Kind;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * An object's threshold over participants. Means are of logarithms: polygons matter by their ratio.
 *
 * @param original polygons of the original
 * @param estimates of the participants whose trials with it are over
 */
record ObjectThreshold(String object, int original, List<ThresholdEstimate> estimates) {
  private static final double CONFIDENCE = 0.95;

  ObjectThreshold {
    estimates = List.copyOf(estimates);
  }

  long count(Kind kind) {
    return estimates.stream().filter(estimate -> estimate.kind() == kind).count();
  }

  /** Of those that say something: where a threshold lies beyond the versions, their end counts. */
  private double[] logs() {
    return estimates.stream()
        .filter(estimate -> estimate.kind() != Kind.OPEN)
        .mapToDouble(estimate -> Math.log(estimate.polygons()))
        .toArray();
  }

  /** The geometric mean of the participants' thresholds; NaN where there are none. */
  double mean() {
    return Math.exp(meanOf(logs()));
  }

  private static double meanOf(double[] logs) {
    double sum = 0;
    for (double log : logs) {
      sum += log;
    }
    return sum / logs.length;
  }

  /**
   * The factor by which the 95 % confidence interval goes below and above the mean; NaN for one.
   */
  private double factor() {
    double[] logs = logs();
    double mean = meanOf(logs);
    double squares = 0;
    for (double log : logs) {
      squares += (log - mean) * (log - mean);
    }
    int n = logs.length;
    return n < 2
        ? Double.NaN
        : Math.exp(Tails.tQuantile(CONFIDENCE, n - 1) * Math.sqrt(squares / (n - 1) / n));
  }

  /** The lower end of the 95 % confidence interval. */
  double low() {
    return mean() / factor();
  }

  /** Its upper end. */
  double high() {
    return mean() * factor();
  }

  /**
   * The polygons of the version to make; empty where half of the participants or more needed more
   * than any version had, or nobody's threshold is known.
   */
  Optional<Integer> wanted() {
    int known = logs().length;
    return known == 0 || 2 * count(Kind.ABOVE) >= known
        ? Optional.empty()
        : Optional.of(Math.min(original, (int) Math.ceil(mean() - 1e-9)));
  }
}
