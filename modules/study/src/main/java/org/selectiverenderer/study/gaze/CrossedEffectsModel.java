package org.selectiverenderer.study.gaze;

import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * A normal model of observations with crossed random effects of objects and of participants, fixed
 * intercepts of groups and a slope:
 *
 * <pre>y = intercept(group) + slope x + object + participant + error</pre>
 *
 * The effects of objects are predicted by Henderson's mixed model equations (Henderson 1975, Best
 * linear unbiased estimation and prediction under a selection model), which shrink those with
 * little data towards 0; the variances are those of restricted maximum likelihood, found by
 * expectation maximisation, each with a weak prior, since few objects or participants tell little
 * of them. Objects are eliminated first, so that a step costs the cube of the number of
 * participants; an object is tied only to its own group and to those who saw it, and sums over the
 * observations are made once.
 */
final class CrossedEffectsModel {
  /** Priors of the variances: as if so many effects had been seen with this standard deviation. */
  private static final double PRIOR_COUNT = 2;

  private static final double OBJECTS = 0.5;
  private static final double PARTICIPANTS = 0.2;
  private static final double PRIOR_ERRORS = 8;

  /** Standard deviation of the slope's prior about 0; intercepts have none to speak of. */
  private static final double SLOPE = 1;

  private static final double INTERCEPT = 1e3;
  private static final int STEPS = 100;
  private static final double CLOSE = 1e-3;

  /**
   * An observation.
   *
   * @param object from 0
   * @param participant from 0
   * @param group from 0
   * @param weight inverse of the error's variance, up to a common factor near 1
   */
  record Observation(int object, int participant, int group, double x, double y, double weight) {}

  /**
   * A fitted model.
   *
   * @param objects predicted effects of the objects
   * @param deviations standard deviation of each effect given the data; includes what is unknown of
   *     intercepts, slope and participants
   * @param slope of y over x
   * @param spread standard deviation of the objects' effects
   */
  record Fit(double[] objects, double[] deviations, double slope, double spread) {}

  private final List<Observation> data;
  private final int objects;
  private final int participants;
  private final int groups;

  /** Sums over the observations as if errors had the variance 1; the upper half. */
  private final double[][] sums;

  private final double[] products;
  private final Tie[] ties;
  private double ofObjects = OBJECTS * OBJECTS;
  private double ofParticipants = PARTICIPANTS * PARTICIPANTS;
  private double ofErrors = 1;

  private CrossedEffectsModel(List<Observation> data) {
    this.data = data;
    objects = 1 + data.stream().mapToInt(Observation::object).max().orElseThrow();
    participants = 1 + data.stream().mapToInt(Observation::participant).max().orElseThrow();
    groups = 1 + data.stream().mapToInt(Observation::group).max().orElseThrow();
    int width = groups + 1 + participants;
    sums = new double[width][width];
    products = new double[width];
    ties = tie(width);
  }

  /**
   * An object's part of the mixed model equations, as if errors had the variance 1.
   *
   * @param at the other unknowns that it shares observations with, ascending
   * @param values its coefficient with each
   */
  private record Tie(int[] at, double[] values, double diagonal, double product) {}

  private Tie[] tie(int width) {
    double[][] between = new double[objects][width];
    double[] diagonal = new double[objects];
    double[] own = new double[objects];
    for (Observation each : data) {
      double weight = each.weight();
      int[] at = {each.group(), groups, groups + 1 + each.participant()};
      double[] value = {1, each.x(), 1};
      for (int a = 0; a < at.length; a++) {
        for (int b = a; b < at.length; b++) {
          sums[at[a]][at[b]] += weight * value[a] * value[b];
        }
        products[at[a]] += weight * value[a] * each.y();
        between[each.object()][at[a]] += weight * value[a];
      }
      diagonal[each.object()] += weight;
      own[each.object()] += weight * each.y();
    }
    Tie[] all = new Tie[objects];
    for (int k = 0; k < objects; k++) {
      double[] row = between[k];
      int[] at = IntStream.range(0, width).filter(i -> row[i] != 0).toArray();
      all[k] =
          new Tie(at, IntStream.of(at).mapToDouble(i -> row[i]).toArray(), diagonal[k], own[k]);
    }
    return all;
  }

  /** Fits a model to at least one observation. */
  static Fit fit(List<Observation> data) {
    return new CrossedEffectsModel(data).fit();
  }

  private Fit fit() {
    Solution solution = solve();
    for (int step = 0; step < STEPS; step++) {
      double before = ofObjects;
      double beforeErrors = ofErrors;
      improve(solution);
      solution = solve();
      if (Math.abs(ofObjects - before) <= CLOSE * before
          && Math.abs(ofErrors - beforeErrors) <= CLOSE * beforeErrors) {
        break;
      }
    }
    double[] deviations = new double[objects];
    for (int k = 0; k < objects; k++) {
      deviations[k] = Math.sqrt(solution.variances[k]);
    }
    return new Fit(solution.effects, deviations, solution.others[groups], Math.sqrt(ofObjects));
  }

  /**
   * The solution for given variances.
   *
   * @param others intercepts, slope, effects of participants
   * @param inverse their covariance
   */
  private record Solution(
      double[] effects, double[] variances, double[] others, RealMatrix inverse) {}

  private Solution solve() {
    int width = groups + 1 + participants;
    double precision = 1 / ofErrors;
    double[][] left = new double[width][width];
    double[] right = new double[width];
    for (int i = 0; i < width; i++) {
      for (int j = i; j < width; j++) {
        left[i][j] = precision * sums[i][j];
      }
      right[i] = precision * products[i];
      left[i][i] +=
          i < groups
              ? 1 / (INTERCEPT * INTERCEPT)
              : i == groups ? 1 / (SLOPE * SLOPE) : 1 / ofParticipants;
    }
    for (Tie tie : ties) {
      double factor = precision * precision / (precision * tie.diagonal + 1 / ofObjects);
      for (int a = 0; a < tie.at.length; a++) {
        double share = factor * tie.values[a];
        double[] row = left[tie.at[a]];
        right[tie.at[a]] -= share * tie.product;
        for (int b = a; b < tie.at.length; b++) {
          row[tie.at[b]] -= share * tie.values[b];
        }
      }
    }
    RealMatrix inverse = inverse(left);
    double[] others = inverse.operate(right);
    double[][] covariance = inverse.getData();
    double[] effects = new double[objects];
    double[] variances = new double[objects];
    for (int k = 0; k < objects; k++) {
      Tie tie = ties[k];
      double diagonal = precision * tie.diagonal + 1 / ofObjects;
      double fitted = 0;
      double square = 0;
      for (int a = 0; a < tie.at.length; a++) {
        double[] row = covariance[tie.at[a]];
        double half = row[tie.at[a]] * tie.values[a] / 2;
        for (int b = a + 1; b < tie.at.length; b++) {
          half += row[tie.at[b]] * tie.values[b];
        }
        square += 2 * tie.values[a] * half;
        fitted += tie.values[a] * others[tie.at[a]];
      }
      effects[k] = precision * (tie.product - fitted) / diagonal;
      variances[k] = 1 / diagonal + precision * precision * square / (diagonal * diagonal);
    }
    return new Solution(effects, variances, others, inverse);
  }

  private static RealMatrix inverse(double[][] symmetric) {
    for (int i = 0; i < symmetric.length; i++) {
      for (int j = 0; j < i; j++) {
        symmetric[i][j] = symmetric[j][i];
      }
    }
    return new CholeskyDecomposition(new Array2DRowRealMatrix(symmetric, false), 1e-6, 1e-14)
        .getSolver()
        .getInverse();
  }

  /** Improves the variances by a step of expectation maximisation. */
  private void improve(Solution solution) {
    double sum = PRIOR_COUNT * OBJECTS * OBJECTS;
    for (int k = 0; k < objects; k++) {
      sum += solution.effects[k] * solution.effects[k] + solution.variances[k];
    }
    ofObjects = sum / (PRIOR_COUNT + objects);
    sum = PRIOR_COUNT * PARTICIPANTS * PARTICIPANTS;
    for (int p = 0; p < participants; p++) {
      int at = groups + 1 + p;
      sum += solution.others[at] * solution.others[at] + solution.inverse.getEntry(at, at);
    }
    ofParticipants = sum / (PRIOR_COUNT + participants);
    double errors = PRIOR_ERRORS;
    for (Observation each : data) {
      double fitted =
          solution.others[each.group()]
              + each.x() * solution.others[groups]
              + solution.others[groups + 1 + each.participant()]
              + solution.effects[each.object()];
      errors += each.weight() * each.y() * (each.y() - fitted);
    }
    double freedom = PRIOR_ERRORS + data.size() - groups - 1;
    ofErrors = Math.max(errors / Math.max(freedom, 1), 1e-6);
  }
}
