package org.selectiverenderer.statistics.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.distribution.NormalDistribution;

/**
 * Finds the observers whose corrected scores have the means, and as far as possible the standard
 * deviations, that a study printed. The scores of few objects are coarse and the log-linear
 * correction pulls them towards 0, so true d' and c are not the printed means; they are found from
 * the exact expectations of the scores, without simulation: hits and false alarms are binomial
 * given a participant, and participants are integrated by Gauss-Hermite quadrature.
 *
 * <p>The spreads between participants are fitted to the standard deviations of the first level.
 * Where binomial scatter alone exceeds a printed deviation the spread is 0.
 */
public final class ScoreCalibration {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);
  private static final GaussIntegrator RULE = new GaussIntegratorFactory().hermite(12);
  private static final int ROUNDS = 4;
  private static final int HALVINGS = 24;
  private static final double WIDEST = 1.5;

  /** Corrected z of each count, for one number of objects (Hautus 1995). */
  private final double[] scores;

  private ScoreCalibration(int objects) {
    scores = new double[objects + 1];
    for (int count = 0; count <= objects; count++) {
      scores[count] = NORMAL.inverseCumulativeProbability((count + 0.5) / (objects + 1));
    }
  }

  /**
   * The observers that were found.
   *
   * @param exact whether the means of all levels are reached: the rates of "yes" must not rise with
   *     the level, and where printed means would have them rise they stay as they are
   */
  public record Calibrated(RecognitionObserver observer, boolean exact) {}

  /**
   * Finds the observers.
   *
   * @param levels what all answers, those of confidence 3 to 5 and those of 5 shall score
   * @param objects number of present, and also of absent, objects of the list
   */
  public static Calibrated of(List<ScoreTarget> levels, int objects) {
    if (levels.size() != RecognitionObserver.LEVELS || objects < 1) {
      throw new IllegalArgumentException("three levels and at least one object are needed");
    }
    return new ScoreCalibration(objects).calibrated(levels);
  }

  private Calibrated calibrated(List<ScoreTarget> levels) {
    ScoreTarget all = levels.get(0);
    double sensitivity = 0.3;
    double criterion = 0.25;
    for (int round = 0; round < ROUNDS; round++) {
      double c = criterion;
      sensitivity =
          spread(all.dPrimeSd(), s -> moments(rates(all, marginal(s, c)), s, c).sensitivitySd());
      double s = sensitivity;
      criterion = spread(all.logBetaSd(), x -> moments(rates(all, marginal(s, x)), s, x).biasSd());
    }
    List<Double> hits = new ArrayList<>();
    List<Double> falseAlarms = new ArrayList<>();
    boolean exact = true;
    for (ScoreTarget level : levels) {
      double[] rates = rates(level, marginal(sensitivity, criterion));
      exact &= lower(hits, rates[0]) & lower(falseAlarms, rates[1]);
    }
    return new Calibrated(
        new RecognitionObserver(hits, falseAlarms, sensitivity, criterion), exact);
  }

  /** Adds a rate that is no larger than the last; returns whether it was so already. */
  private static boolean lower(List<Double> rates, double rate) {
    double limit = rates.isEmpty() ? rate : rates.get(rates.size() - 1);
    rates.add(Math.min(limit, rate));
    return rate <= limit;
  }

  /** Returns the standard deviation of the z of a rate between participants. */
  private static double marginal(double sensitivity, double criterion) {
    return Math.sqrt(sensitivity * sensitivity / 4 + criterion * criterion);
  }

  /** Finds by bisection the spread with which a standard deviation, which rises with it, is met. */
  private static double spread(double wanted, DoubleUnaryOperator deviation) {
    if (deviation.applyAsDouble(0) >= wanted) {
      return 0;
    }
    double low = 0;
    double high = WIDEST;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2;
      if (deviation.applyAsDouble(middle) < wanted) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return (low + high) / 2;
  }

  /**
   * Finds the z of both rates with which the mean scores are those wanted, by Newton's method in d'
   * and c, halving a step that does not come nearer.
   */
  private double[] rates(ScoreTarget wanted, double spread) {
    double d = wanted.dPrime();
    double c = Math.abs(d) > 0.05 ? Math.max(-1, Math.min(1, wanted.logBeta() / d)) : 0;
    double[] error = error(wanted, d, c, spread);
    for (int step = 0; step < 60 && norm(error) > 1e-9; step++) {
      double h = 1e-5;
      double[] byD = error(wanted, d + h, c, spread);
      double[] byC = error(wanted, d, c + h, spread);
      double a = (byD[0] - error[0]) / h;
      double b = (byC[0] - error[0]) / h;
      double e = (byD[1] - error[1]) / h;
      double f = (byC[1] - error[1]) / h;
      double determinant = a * f - b * e;
      double moveD = (f * error[0] - b * error[1]) / determinant;
      double moveC = (a * error[1] - e * error[0]) / determinant;
      double share = 1;
      double[] next = error(wanted, d - moveD, c - moveC, spread);
      while (!(norm(next) < norm(error)) && share > 1e-4) {
        share /= 2;
        next = error(wanted, d - share * moveD, c - share * moveC, spread);
      }
      d -= share * moveD;
      c -= share * moveC;
      error = next;
    }
    return new double[] {d / 2 - c, -d / 2 - c};
  }

  private static double norm(double[] error) {
    return Math.hypot(error[0], error[1]);
  }

  private double[] error(ScoreTarget wanted, double d, double c, double spread) {
    double[] hits = averaged(d / 2 - c, spread);
    double[] falseAlarms = averaged(-d / 2 - c, spread);
    return new double[] {
      hits[0] - falseAlarms[0] - wanted.dPrime(), (falseAlarms[1] - hits[1]) / 2 - wanted.logBeta()
    };
  }

  /** Returns the means of a score and of its square over participants. */
  private double[] averaged(double mean, double spread) {
    double first = 0;
    double second = 0;
    for (int i = 0; i < RULE.getNumberOfPoints(); i++) {
      double[] powers = powers(mean + spread * Math.sqrt(2) * RULE.getPoint(i));
      first += RULE.getWeight(i) * powers[0];
      second += RULE.getWeight(i) * powers[1];
    }
    return new double[] {first / Math.sqrt(Math.PI), second / Math.sqrt(Math.PI)};
  }

  /** Returns the means of the score, its square and its fourth power at a true z. */
  private double[] powers(double z) {
    int n = scores.length - 1;
    double rate = Math.max(1e-12, Math.min(1 - 1e-12, NORMAL.cumulativeProbability(z)));
    double probability = Math.pow(1 - rate, n);
    double[] sums = new double[3];
    for (int count = 0; count <= n; count++) {
      double square = scores[count] * scores[count];
      sums[0] += probability * scores[count];
      sums[1] += probability * square;
      sums[2] += probability * square * square;
      probability *= (double) (n - count) / (count + 1) * rate / (1 - rate);
    }
    return sums;
  }

  /** Standard deviations of the scores over participants, their scatter included. */
  private record Moments(double sensitivitySd, double biasSd) {}

  private Moments moments(double[] rates, double sensitivity, double criterion) {
    double d = 0;
    double d2 = 0;
    double b = 0;
    double b2 = 0;
    for (int i = 0; i < RULE.getNumberOfPoints(); i++) {
      double half = sensitivity * Math.sqrt(2) * RULE.getPoint(i) / 2;
      for (int j = 0; j < RULE.getNumberOfPoints(); j++) {
        double c = criterion * Math.sqrt(2) * RULE.getPoint(j);
        double weight = RULE.getWeight(i) * RULE.getWeight(j) / Math.PI;
        double[] h = powers(rates[0] + half - c);
        double[] f = powers(rates[1] - half - c);
        d += weight * (h[0] - f[0]);
        d2 += weight * (h[1] + f[1] - 2 * h[0] * f[0]);
        b += weight * (f[1] - h[1]) / 2;
        b2 += weight * (f[2] + h[2] - 2 * h[1] * f[1]) / 4;
      }
    }
    return new Moments(Math.sqrt(Math.max(0, d2 - d * d)), Math.sqrt(Math.max(0, b2 - b * b)));
  }
}
