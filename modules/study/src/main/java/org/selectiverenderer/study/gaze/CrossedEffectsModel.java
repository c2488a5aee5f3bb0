package org.selectiverenderer.study.gaze;

import java.util.List;
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
 * participants.
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
  private double ofObjects = OBJECTS * OBJECTS;
  private double ofParticipants = PARTICIPANTS * PARTICIPANTS;
  private double ofErrors = 1;

  private CrossedEffectsModel(List<Observation> data) {
    this.data = data;
    objects = 1 + data.stream().mapToInt(Observation::object).max().orElseThrow();
    participants = 1 + data.stream().mapToInt(Observation::participant).max().orElseThrow();
    groups = 1 + data.stream().mapToInt(Observation::group).max().orElseThrow();
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
    double[][] left = new double[width][width];
    double[] right = new double[width];
    double[][] between = new double[objects][width];
    double[] diagonal = new double[objects];
    double[] own = new double[objects];
    for (Observation each : data) {
      double weight = each.weight() / ofErrors;
      int[] at = {each.group(), groups, groups + 1 + each.participant()};
      double[] value = {1, each.x(), 1};
      for (int a = 0; a < at.length; a++) {
        for (int b = 0; b < at.length; b++) {
          left[at[a]][at[b]] += weight * value[a] * value[b];
        }
        right[at[a]] += weight * value[a] * each.y();
        between[each.object()][at[a]] += weight * value[a];
      }
      diagonal[each.object()] += weight;
      own[each.object()] += weight * each.y();
    }
    for (int i = 0; i < width; i++) {
      left[i][i] +=
          i < groups
              ? 1 / (INTERCEPT * INTERCEPT)
              : i == groups ? 1 / (SLOPE * SLOPE) : 1 / ofParticipants;
    }
    for (int k = 0; k < objects; k++) {
      diagonal[k] += 1 / ofObjects;
      for (int i = 0; i < width; i++) {
        double share = between[k][i] / diagonal[k];
        if (share != 0) {
          right[i] -= share * own[k];
          for (int j = 0; j < width; j++) {
            left[i][j] -= share * between[k][j];
          }
        }
      }
    }
    RealMatrix inverse = inverse(left);
    double[] others = inverse.operate(right);
    double[] effects = new double[objects];
    double[] variances = new double[objects];
    for (int k = 0; k < objects; k++) {
      double[] spread = inverse.operate(between[k]);
      double fitted = 0;
      double square = 0;
      for (int i = 0; i < width; i++) {
        fitted += between[k][i] * others[i];
        square += between[k][i] * spread[i];
      }
      effects[k] = (own[k] - fitted) / diagonal[k];
      variances[k] = 1 / diagonal[k] + square / (diagonal[k] * diagonal[k]);
    }
    return new Solution(effects, variances, others, inverse);
  }

  private static RealMatrix inverse(double[][] symmetric) {
    // Both halves are rounded differently; the decomposition rejects what is not symmetric.
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
