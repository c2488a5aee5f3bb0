package org.selectiverenderer.study.threshold;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.distribution.TailProbabilities;
import org.selectiverenderer.study.threshold.ThresholdEstimate.Kind;

/**
 * The threshold of an object over participants. Means are those of logarithms, as the effect of
 * polygons depends on their ratio.
 *
 * @param original number of polygons of the original
 * @param estimates the estimates of the participants whose trials with the object are over
 */
record ObjectThreshold(String object, int original, List<ThresholdEstimate> estimates) {
  private static final double CONFIDENCE = 0.95;

  ObjectThreshold {
    estimates = List.copyOf(estimates);
  }

  long count(Kind kind) {
    return estimates.stream().filter(estimate -> estimate.kind() == kind).count();
  }

  /**
   * Returns the logarithms of the known thresholds; one beyond the versions counts as that of the
   * first or last version.
   */
  private double[] logs() {
    return estimates.stream()
        .filter(estimate -> estimate.kind() != Kind.OPEN)
        .mapToDouble(estimate -> Math.log(estimate.polygons()))
        .toArray();
  }

  /** Returns the geometric mean of the participants' thresholds; NaN if there are none. */
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
   * Returns the factor by which the 95 % confidence interval extends below and above the mean; NaN
   * for fewer than two participants.
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
        : Math.exp(
            TailProbabilities.tQuantile(CONFIDENCE, n - 1) * Math.sqrt(squares / (n - 1) / n));
  }

  /** Returns the lower end of the 95 % confidence interval. */
  double low() {
    return mean() / factor();
  }

  /** Returns the upper end of the 95 % confidence interval. */
  double high() {
    return mean() * factor();
  }

  /**
   * Returns the number of polygons of the recommended version; empty if at least half of the
   * participants needed more polygons than any reduced version had, or no threshold is known.
   */
  Optional<Integer> wanted() {
    int known = logs().length;
    return known == 0 || 2 * count(Kind.ABOVE) >= known
        ? Optional.empty()
        : Optional.of(Math.min(original, (int) Math.ceil(mean() - 1e-9)));
  }
}
