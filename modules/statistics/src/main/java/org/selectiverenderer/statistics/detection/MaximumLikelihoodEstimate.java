package org.selectiverenderer.statistics.detection;

import java.util.Optional;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * A maximum likelihood estimate, found by Fisher scoring: Newton steps with the expected
 * information, halved until the likelihood grows.
 *
 * @param at the parameters: a, b and the criteria
 * @param log the log likelihood at the estimate
 * @param covariance covariance matrix of the parameters: the inverse of the expected information
 */
record MaximumLikelihoodEstimate(double[] at, double log, RealMatrix covariance) {
  private static final int STEPS = 500;
  private static final int HALVINGS = 40;

  /** The Newton decrement per rating at which the search ends. */
  private static final double NEGLIGIBLE = 1e-16;

  /** A parameter beyond this is diverging: no realistic sample can distinguish 12 from 13. */
  private static final double FAR = 12;

  /** Below this, the information matrix counts as singular. */
  private static final double SINGULAR = 1e-11;

  /** Returns the estimate; empty when there is no finite one. */
  static Optional<MaximumLikelihoodEstimate> of(RatingLikelihood likelihood) {
    double[] at = likelihood.start();
    double log = likelihood.log(at);
    for (int step = 0; step < STEPS; step++) {
      RealMatrix information = likelihood.information(at);
      LUDecomposition solver = new LUDecomposition(information, SINGULAR);
      if (!solver.getSolver().isNonSingular() || !finite(at)) {
        return Optional.empty();
      }
      RealVector score = MatrixUtils.createRealVector(likelihood.score(at));
      RealVector move = solver.getSolver().solve(score);
      if (move.dotProduct(score) <= NEGLIGIBLE * Math.max(1, -log)) {
        return Optional.of(new MaximumLikelihoodEstimate(at, log, solver.getSolver().getInverse()));
      }
      boolean better = false;
      for (int half = 0; half < HALVINGS && !better; half++) {
        double[] next =
            MatrixUtils.createRealVector(at).add(move.mapMultiply(Math.pow(0.5, half))).toArray();
        if (likelihood.allows(next)) {
          double nextLog = likelihood.log(next);
          if (nextLog > log) {
            at = next;
            log = nextLog;
            better = true;
          }
        }
      }
      if (!better) {
        // No step improves the likelihood to the last digit: this is the maximum if the gradient is
        // small too.
        return move.dotProduct(score) < 1e-10 * Math.max(1, -log)
            ? Optional.of(new MaximumLikelihoodEstimate(at, log, solver.getSolver().getInverse()))
            : Optional.empty();
      }
    }
    return Optional.empty();
  }

  private static boolean finite(double[] at) {
    for (double value : at) {
      if (!(Math.abs(value) < FAR)) {
        return false;
      }
    }
    return true;
  }
}
