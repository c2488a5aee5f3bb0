package org.selectiverenderer.statistics.detection;

import java.util.List;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * The likelihood of ratings under two normal distributions (Dorfman and Alf 1969, Journal of
 * Mathematical Psychology 6): absent objects have mean 0 and standard deviation 1, and a present
 * object's rating stays below a criterion c with probability Phi(b c - a).
 *
 * <p>Parameters are a, b and the criteria in rising order. Where the slope is fixed, b is 1 and its
 * derivatives are 0.
 */
final class RatingLikelihood {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /** The first criterion's index among the parameters. */
  static final int CRITERIA = 2;

  private final RatingCounts ratings;
  private final boolean slopeFixed;

  /**
   * @param ratings ratings without unused categories
   */
  RatingLikelihood(RatingCounts ratings, boolean slopeFixed) {
    this.ratings = ratings;
    this.slopeFixed = slopeFixed;
  }

  /**
   * Probabilities of the categories and their derivatives by the parameters, for present or for
   * absent objects.
   */
  private record Cells(double[] probability, double[][] derivative) {}

  int parameters() {
    return CRITERIA + ratings.categories() - 1;
  }

  /** Returns whether the criteria are in ascending order and the slope is above 0. */
  boolean allows(double[] at) {
    for (int i = CRITERIA + 1; i < at.length; i++) {
      if (!(at[i] > at[i - 1])) {
        return false;
      }
    }
    return at[1] > 0;
  }

  /**
   * Returns start values: criteria are from the ratings of absent objects, smoothed by one rating
   * spread over all categories.
   */
  double[] start() {
    double[] start = new double[parameters()];
    int categories = ratings.categories();
    double share = 1.0 / categories;
    double noise = 0;
    double signal = 0;
    start[1] = 1;
    for (int i = 0; i < categories - 1; i++) {
      noise += ratings.noise().get(i) + share;
      signal += ratings.signal().get(i) + share;
      double below = NORMAL.inverseCumulativeProbability(noise / (ratings.noiseTotal() + 1));
      double signalBelow =
          NORMAL.inverseCumulativeProbability(signal / (ratings.signalTotal() + 1));
      start[CRITERIA + i] = below;
      start[0] += (below - signalBelow) / (categories - 1);
    }
    return start;
  }

  /**
   * Returns the log likelihood without its constant; minus infinity where an observed category has
   * probability 0.
   */
  double log(double[] at) {
    double[] noise = noise(at).probability();
    double[] signal = signal(at).probability();
    double log = 0;
    for (int i = 0; i < noise.length; i++) {
      log += term(ratings.noise().get(i), noise[i]) + term(ratings.signal().get(i), signal[i]);
    }
    return log;
  }

  private static double term(int count, double probability) {
    return count == 0 ? 0 : count * Math.log(probability);
  }

  /** Returns the log likelihood of the saturated model, which fits every category exactly. */
  double saturatedLog() {
    double log = 0;
    for (int i = 0; i < ratings.categories(); i++) {
      int noise = ratings.noise().get(i);
      int signal = ratings.signal().get(i);
      log += term(noise, (double) noise / ratings.noiseTotal());
      log += term(signal, (double) signal / ratings.signalTotal());
    }
    return log;
  }

  /** Returns the gradient of {@link #log}. */
  double[] score(double[] at) {
    double[] score = new double[at.length];
    add(score, noise(at), ratings.noise());
    add(score, signal(at), ratings.signal());
    return score;
  }

  private static void add(double[] score, Cells cells, List<Integer> counts) {
    for (int i = 0; i < counts.size(); i++) {
      if (counts.get(i) > 0) {
        for (int j = 0; j < score.length; j++) {
          score[j] += counts.get(i) / cells.probability()[i] * cells.derivative()[i][j];
        }
      }
    }
  }

  /**
   * Returns the expected information matrix; for a fixed slope, its row and column are those of the
   * identity.
   */
  RealMatrix information(double[] at) {
    RealMatrix information = new Array2DRowRealMatrix(at.length, at.length);
    add(information, noise(at), ratings.noiseTotal());
    add(information, signal(at), ratings.signalTotal());
    if (slopeFixed) {
      information.setEntry(1, 1, 1);
    }
    return information;
  }

  private static void add(RealMatrix information, Cells cells, int total) {
    int size = information.getRowDimension();
    for (int i = 0; i < cells.probability().length; i++) {
      double[] derivative = cells.derivative()[i];
      for (int row = 0; row < size; row++) {
        for (int column = 0; column < size; column++) {
          information.addToEntry(
              row, column, total * derivative[row] * derivative[column] / cells.probability()[i]);
        }
      }
    }
  }

  private Cells noise(double[] at) {
    int criteria = at.length - CRITERIA;
    double[] below = new double[criteria];
    double[][] slopes = new double[criteria][at.length];
    for (int i = 0; i < criteria; i++) {
      double c = at[CRITERIA + i];
      below[i] = c;
      slopes[i][CRITERIA + i] = NORMAL.density(c);
    }
    return cells(below, slopes, at.length);
  }

  private Cells signal(double[] at) {
    int criteria = at.length - CRITERIA;
    double[] below = new double[criteria];
    double[][] slopes = new double[criteria][at.length];
    for (int i = 0; i < criteria; i++) {
      double c = at[CRITERIA + i];
      below[i] = at[1] * c - at[0];
      double density = NORMAL.density(below[i]);
      slopes[i][0] = -density;
      slopes[i][1] = slopeFixed ? 0 : c * density;
      slopes[i][CRITERIA + i] = at[1] * density;
    }
    return cells(below, slopes, at.length);
  }

  /**
   * Returns the probabilities of the categories between adjacent criteria, and beyond the first and
   * the last one.
   */
  private static Cells cells(double[] bounds, double[][] slopes, int parameters) {
    int categories = bounds.length + 1;
    double[] probability = new double[categories];
    double[][] derivative = new double[categories][parameters];
    for (int i = 0; i < categories; i++) {
      probability[i] =
          i == 0
              ? NORMAL.cumulativeProbability(bounds[0])
              : i == bounds.length
                  ? NORMAL.cumulativeProbability(-bounds[i - 1])
                  : between(bounds[i - 1], bounds[i]);
      for (int j = 0; j < parameters; j++) {
        derivative[i][j] = (i < bounds.length ? slopes[i][j] : 0) - (i > 0 ? slopes[i - 1][j] : 0);
      }
    }
    return new Cells(probability, derivative);
  }

  /**
   * Returns the normal probability between two bounds, computed in the tail that avoids
   * cancellation.
   */
  private static double between(double low, double high) {
    return low > 0
        ? NORMAL.cumulativeProbability(-low) - NORMAL.cumulativeProbability(-high)
        : NORMAL.cumulativeProbability(high) - NORMAL.cumulativeProbability(low);
  }
}
