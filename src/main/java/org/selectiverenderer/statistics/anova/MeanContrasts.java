package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * Weighted sums of cell means, with the error of the multivariate model: var(sum of w_jk m_jk) =
 * sum over groups of w_j' S w_j / n_j, S the pooled covariance of the within levels on N - g
 * degrees of freedom. No sphericity is assumed (Maxwell and Delaney 2004, 14.6; Searle, Speed and
 * Milliken 1980).
 */
final class MeanContrasts {
  private final Design design;
  private final CellStatistics cells;
  private final AnovaOptions options;
  private final RealMatrix covariance;

  /** Pooled standard deviation of a score in its cell. */
  private final double deviation;

  MeanContrasts(Design design, CellStatistics cells, AnovaOptions options) {
    this.design = design;
    this.cells = cells;
    this.options = options;
    covariance = cells.covariance();
    deviation = Math.sqrt(covariance.getTrace() / cells.levels());
  }

  /** TOST's bound in the measure's units. */
  double bound() {
    return options.rawBound() ? options.differenceBound() : options.differenceBound() * deviation;
  }

  /** All marginal means: of the groups, of the within levels, of the cells. */
  List<MarginalMean> means() {
    List<MarginalMean> means = new ArrayList<>();
    means.add(mean(-1, -1));
    for (int group = 0; cells.groups() > 1 && group < cells.groups(); group++) {
      means.add(mean(group, -1));
    }
    for (int level = 0; cells.levels() > 1 && level < cells.levels(); level++) {
      means.add(mean(-1, level));
    }
    if (cells.groups() > 1 && cells.levels() > 1) {
      for (int level = 0; level < cells.levels(); level++) {
        for (int group = 0; group < cells.groups(); group++) {
          means.add(mean(group, level));
        }
      }
    }
    return means;
  }

  private MarginalMean mean(int group, int level) {
    double[][] weights = weights(group, level);
    double mean = sum(weights);
    double error = standardError(weights);
    double half = Tails.tQuantile(options.confidence(), cells.errorDf()) * error;
    return new MarginalMean(
        level < 0 ? Optional.empty() : Optional.of(design.within().levels().get(level)),
        group < 0 ? Optional.empty() : Optional.of(design.between().levels().get(group)),
        mean,
        error,
        cells.errorDf(),
        mean - half,
        mean + half);
  }

  /**
   * All pairs of levels, in families that Holm holds to one level of error each: of groups over
   * all, of within levels over all, of groups at each within level, of within levels in each group.
   */
  List<Comparison> comparisons() {
    List<Comparison> all = new ArrayList<>(groups(-1));
    all.addAll(levels(-1));
    if (cells.groups() > 1 && cells.levels() > 1) {
      for (int level = 0; level < cells.levels(); level++) {
        all.addAll(groups(level));
      }
      for (int group = 0; group < cells.groups(); group++) {
        all.addAll(levels(group));
      }
      all.addAll(interactions());
    }
    return all;
  }

  private List<Comparison> groups(int level) {
    List<Comparison> family = new ArrayList<>();
    for (int a = 0; a < cells.groups(); a++) {
      for (int b = a + 1; b < cells.groups(); b++) {
        double na = cells.size(a);
        double nb = cells.size(b);
        family.add(
            comparison(
                design.between().name(),
                level < 0 ? Optional.empty() : Optional.of(design.within().levels().get(level)),
                design.between().levels().get(a),
                design.between().levels().get(b),
                minus(weights(a, level), weights(b, level)),
                na * nb / (na + nb)));
      }
    }
    return adjusted(family);
  }

  private List<Comparison> levels(int group) {
    List<Comparison> family = new ArrayList<>();
    for (int a = 0; a < cells.levels(); a++) {
      for (int b = a + 1; b < cells.levels(); b++) {
        family.add(
            comparison(
                design.within().name(),
                group < 0 ? Optional.empty() : Optional.of(design.between().levels().get(group)),
                design.within().levels().get(a),
                design.within().levels().get(b),
                minus(weights(group, a), weights(group, b)),
                group < 0 ? cells.effectiveSubjects() : cells.size(group)));
      }
    }
    return adjusted(family);
  }

  /** The difference of two levels in one group less that in another. */
  private List<Comparison> interactions() {
    List<Comparison> family = new ArrayList<>();
    List<String> levels = design.within().levels();
    for (int a = 0; a < cells.groups(); a++) {
      for (int b = a + 1; b < cells.groups(); b++) {
        for (int j = 0; j < cells.levels(); j++) {
          for (int k = j + 1; k < cells.levels(); k++) {
            double na = cells.size(a);
            double nb = cells.size(b);
            String pair = " (" + levels.get(j) + " − " + levels.get(k) + ")";
            family.add(
                comparison(
                    design.within().name() + " x " + design.between().name(),
                    Optional.empty(),
                    design.between().levels().get(a) + pair,
                    design.between().levels().get(b) + pair,
                    minus(minus(weights(a, j), weights(a, k)), minus(weights(b, j), weights(b, k))),
                    na * nb / (na + nb)));
          }
        }
      }
    }
    return adjusted(family);
  }

  private Comparison comparison(
      String factor,
      Optional<String> at,
      String first,
      String second,
      double[][] weights,
      double n) {
    double difference = sum(weights);
    double error = standardError(weights);
    double df = cells.errorDf();
    double half = Tails.tQuantile(options.confidence(), df) * error;
    // A difference of equal scores, as rounding leaves it, has no t.
    boolean constant = error <= 1e-10 * Math.max(Math.abs(difference), deviation);
    double t = constant ? Double.NaN : difference / error;
    double none = Double.NaN;
    return new Comparison(
        factor,
        at,
        first,
        second,
        difference,
        error,
        df,
        difference - half,
        difference + half,
        t,
        constant ? none : Tails.tTwoSided(t, df),
        none,
        deviation == 0 ? none : difference / deviation,
        constant ? new Tost(bound(), none, none, none) : Tost.of(difference, error, df, bound()),
        constant ? none : BayesFactors.jzs(t, df, n, options.priorScale()));
  }

  private static List<Comparison> adjusted(List<Comparison> family) {
    double[] holm = Holm.adjusted(family.stream().map(Comparison::p).toList());
    for (int i = 0; i < holm.length; i++) {
      family.set(i, family.get(i).withHolm(holm[i]));
    }
    return family;
  }

  /** Of a cell; -1 stands for all groups or all levels with equal weights. */
  private double[][] weights(int group, int level) {
    double[][] weights = new double[cells.groups()][cells.levels()];
    for (int g = 0; g < weights.length; g++) {
      for (int k = 0; k < weights[g].length; k++) {
        double ofGroup = group < 0 ? 1.0 / weights.length : group == g ? 1 : 0;
        double ofLevel = level < 0 ? 1.0 / weights[g].length : level == k ? 1 : 0;
        weights[g][k] = ofGroup * ofLevel;
      }
    }
    return weights;
  }

  private static double[][] minus(double[][] a, double[][] b) {
    for (int group = 0; group < a.length; group++) {
      for (int level = 0; level < a[group].length; level++) {
        a[group][level] -= b[group][level];
      }
    }
    return a;
  }

  private double sum(double[][] weights) {
    double sum = 0;
    for (int group = 0; group < weights.length; group++) {
      double[] means = cells.means(group);
      for (int level = 0; level < means.length; level++) {
        sum += weights[group][level] * means[level];
      }
    }
    return sum;
  }

  private double standardError(double[][] weights) {
    double variance = 0;
    for (int group = 0; group < weights.length; group++) {
      RealVector w = MatrixUtils.createRealVector(weights[group]);
      variance += w.dotProduct(covariance.operate(w)) / cells.size(group);
    }
    return Math.sqrt(Math.max(0, variance));
  }
}
