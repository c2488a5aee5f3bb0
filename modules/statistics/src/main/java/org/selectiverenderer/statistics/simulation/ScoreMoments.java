package org.selectiverenderer.statistics.simulation;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.distribution.BinomialDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.selectiverenderer.statistics.detection.DetectionIndices;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.ResponseCounts;

/**
 * The exact means and covariances of a participant's scores under a {@link SimulationModel},
 * without simulation. Given d' and c, hits and false alarms are binomial, so a score has as many
 * values as there are counts; over participants, d' and c are integrated by Gauss-Hermite
 * quadrature.
 *
 * @param means means of the scores, one for each list
 * @param covariances covariances between the scores of one participant; lists share that
 *     participant's d' and c
 */
record ScoreMoments(double[] means, double[][] covariances) {
  private static final int NODES = 24;
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /**
   * Returns the moments of a condition.
   *
   * @param condition index of the condition in the model
   * @param correction one under which every score is finite
   */
  static ScoreMoments of(
      SimulationModel model,
      int condition,
      DetectionMeasure measure,
      ExtremeRateCorrection correction) {
    List<RecognitionListSpec> lists = model.lists();
    double[][][] scores =
        lists.stream().map(list -> scores(list, measure, correction)).toArray(double[][][]::new);
    int size = lists.size();
    double[] sums = new double[size];
    double[][] products = new double[size][size];
    GaussIntegrator rule = new GaussIntegratorFactory().hermite(NODES);
    for (int i = 0; i < NODES; i++) {
      double d = at(model.sensitivities().get(condition), model.sensitivitySpread(), rule, i);
      for (int j = 0; j < NODES; j++) {
        double c = at(model.criteria().get(condition), model.criterionSpread(), rule, j);
        double weight = rule.getWeight(i) * rule.getWeight(j) / Math.PI;
        double[] given = new double[size];
        for (int k = 0; k < size; k++) {
          boolean inconsistent = lists.get(k).type().equals("inconsistent");
          double ownD = d + (inconsistent ? model.typeSensitivity() : 0);
          double ownC = c + (inconsistent ? model.typeCriterion() : 0);
          double hit = NORMAL.cumulativeProbability(ownD / 2 - ownC);
          double falseAlarm = NORMAL.cumulativeProbability(-ownD / 2 - ownC);
          given[k] = mean(scores[k], hit, falseAlarm, score -> score);
          sums[k] += weight * given[k];
          products[k][k] += weight * mean(scores[k], hit, falseAlarm, score -> score * score);
          for (int l = 0; l < k; l++) {
            products[k][l] += weight * given[k] * given[l];
          }
        }
      }
    }
    double[][] covariances = new double[size][size];
    for (int k = 0; k < size; k++) {
      for (int l = 0; l <= k; l++) {
        covariances[k][l] = products[k][l] - sums[k] * sums[l];
        covariances[l][k] = covariances[k][l];
      }
    }
    return new ScoreMoments(sums, covariances);
  }

  private static double at(double mean, double spread, GaussIntegrator rule, int node) {
    return mean + spread * Math.sqrt(2) * rule.getPoint(node);
  }

  /** Returns the score for each number of hits and of false alarms. */
  private static double[][] scores(
      RecognitionListSpec list, DetectionMeasure measure, ExtremeRateCorrection correction) {
    int n = list.present();
    double[][] scores = new double[n + 1][n + 1];
    for (int hits = 0; hits <= n; hits++) {
      for (int falseAlarms = 0; falseAlarms <= n; falseAlarms++) {
        scores[hits][falseAlarms] =
            measure.of(
                DetectionIndices.of(
                    new ResponseCounts(hits, n - hits, falseAlarms, n - falseAlarms), correction));
      }
    }
    return scores;
  }

  private static double mean(
      double[][] scores, double hit, double falseAlarm, DoubleUnaryOperator of) {
    int n = scores.length - 1;
    BinomialDistribution hits = new BinomialDistribution(null, n, hit);
    BinomialDistribution falseAlarms = new BinomialDistribution(null, n, falseAlarm);
    double[] other = new double[n + 1];
    for (int j = 0; j <= n; j++) {
      other[j] = falseAlarms.probability(j);
    }
    double sum = 0;
    for (int i = 0; i <= n; i++) {
      double own = hits.probability(i);
      for (int j = 0; j <= n; j++) {
        sum += own * other[j] * of.applyAsDouble(scores[i][j]);
      }
    }
    return sum;
  }

  /** Returns the mean of a weighted sum of the scores. */
  double mean(double... weights) {
    double sum = 0;
    for (int k = 0; k < weights.length; k++) {
      sum += weights[k] * means[k];
    }
    return sum;
  }

  /** Returns the variance of a weighted sum of the scores. */
  double variance(double... weights) {
    double sum = 0;
    for (int k = 0; k < weights.length; k++) {
      for (int l = 0; l < weights.length; l++) {
        sum += weights[k] * weights[l] * covariances[k][l];
      }
    }
    return sum;
  }
}
