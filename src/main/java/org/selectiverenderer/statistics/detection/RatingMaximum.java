package org.selectiverenderer.statistics.detection;

import java.util.Optional;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * Parameters of largest likelihood, found by Fisher's scoring: Newton's steps with the expected
 * information, halved until the likelihood grows.
 *
 * @param at a, b and the criteria
 * @param log of the likelihood there
 * @param covariance of the parameters: the inverse of the expected information
 */
record RatingMaximum(double[] at, double log, RealMatrix covariance) {
  private static final int STEPS = 500;
  private static final int HALVINGS = 40;

  /** Per rating, the score's decrement at which the search ends. */
  private static final double NEGLIGIBLE = 1e-16;

  /** Parameters beyond are on their way to infinity: no sample of a study tells 12 from 13. */
  private static final double FAR = 12;

  /** Below, the information is that of no sample. */
  private static final double SINGULAR = 1e-11;

  /** Empty when there is no finite one. */
  static Optional<RatingMaximum> of(RatingLikelihood likelihood) {
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
        return Optional.of(new RatingMaximum(at, log, solver.getSolver().getInverse()));
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
        // Nothing is better to the last digit: this is the place, if the slope is as small.
        return move.dotProduct(score) < 1e-10 * Math.max(1, -log)
            ? Optional.of(new RatingMaximum(at, log, solver.getSolver().getInverse()))
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
