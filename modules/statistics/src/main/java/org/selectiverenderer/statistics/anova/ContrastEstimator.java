package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * Estimates marginal means and contrasts: weighted sums u' B w of the coefficients, whose variance
 * is u' (X'X)^-1 u times w' S w. The vector u holds the weights of the groups, w those of the
 * within levels, and S is their pooled covariance. No sphericity is assumed (Maxwell and Delaney
 * 2004, 14.6; Searle, Speed and Milliken 1980).
 */
final class ContrastEstimator {
  private final FactorialDesign design;
  private final MultivariateLinearModel cells;
  private final AnovaOptions options;
  private final RealMatrix covariance;

  /** Pooled standard deviation of a score in its cell. */
  private final double deviation;

  /** Half the width of a confidence interval, in standard errors. */
  private final double half;

  ContrastEstimator(FactorialDesign design, MultivariateLinearModel cells, AnovaOptions options) {
    this.design = design;
    this.cells = cells;
    this.options = options;
    covariance = cells.covariance();
    deviation = Math.sqrt(covariance.getTrace() / cells.levels());
    half = TailProbabilities.tQuantile(options.confidence(), cells.errorDf());
  }

  /** Returns the equivalence bound of TOST in the measure's units. */
  double bound() {
    return options.rawBound() ? options.differenceBound() : options.differenceBound() * deviation;
  }

  /** Returns the grand mean, then the means of every term's combinations of levels. */
  List<MarginalMean> means() {
    List<MarginalMean> means = new ArrayList<>();
    for (Term term : Stream.concat(Stream.of(Term.INTERCEPT), Term.of(design).stream()).toList()) {
      if (term.covariate().isEmpty()) {
        combinations(term).forEach(levels -> means.add(mean(term, levels)));
      }
    }
    return means;
  }

  /** Returns all combinations of levels of a term; the last factor's level changes fastest. */
  private static List<Map<Factor, Integer>> combinations(Term term) {
    List<Map<Factor, Integer>> all = List.of(Map.of());
    for (Factor factor : Stream.concat(term.within().stream(), term.between().stream()).toList()) {
      List<Map<Factor, Integer>> longer = new ArrayList<>();
      for (Map<Factor, Integer> before : all) {
        for (int level = 0; level < factor.levels().size(); level++) {
          Map<Factor, Integer> next = new LinkedHashMap<>(before);
          next.put(factor, level);
          longer.add(next);
        }
      }
      all = longer;
    }
    return all;
  }

  private MarginalMean mean(Term term, Map<Factor, Integer> levels) {
    Map<Factor, double[]> weights = new LinkedHashMap<>();
    Map<String, String> names = new LinkedHashMap<>();
    levels.forEach(
        (factor, level) -> {
          weights.put(factor, at(factor, level));
          names.put(factor.name(), factor.levels().get(level));
        });
    RealVector groups = weights(design.betweenFactors(), weights);
    RealVector within = weights(design.withinFactors(), weights);
    double mean = estimate(groups, within);
    double error = standardError(groups, within);
    return new MarginalMean(
        term, names, mean, error, cells.errorDf(), mean - half * error, mean + half * error);
  }

  /**
   * Returns comparisons of all pairs of levels, in families: pairs of each factor over all other
   * factors; then for each two factors, pairs of one at each level of the other, and the
   * interaction contrasts (differences of differences).
   */
  List<PairwiseComparison> comparisons() {
    List<Factor> factors =
        Stream.concat(design.betweenFactors().stream(), design.withinFactors().stream())
            .filter(Factor::varies)
            .toList();
    List<PairwiseComparison> all = new ArrayList<>();
    factors.forEach(factor -> all.addAll(pairs(factor)));
    for (int i = 0; i < factors.size(); i++) {
      for (int j = i + 1; j < factors.size(); j++) {
        Factor one = factors.get(i);
        Factor other = factors.get(j);
        all.addAll(pairsAtEach(one, other));
        all.addAll(pairsAtEach(other, one));
        all.addAll(interactions(one, other));
      }
    }
    return all;
  }

  /** Returns comparisons of all pairs of levels of a factor, over all levels of the others. */
  List<PairwiseComparison> pairs(Factor factor) {
    return pairs(factor, Map.of(), Optional.empty());
  }

  private List<PairwiseComparison> pairsAtEach(Factor factor, Factor at) {
    List<PairwiseComparison> all = new ArrayList<>();
    for (int level = 0; level < at.levels().size(); level++) {
      all.addAll(pairs(factor, Map.of(at, at(at, level)), Optional.of(at.levels().get(level))));
    }
    return all;
  }

  private List<PairwiseComparison> pairs(
      Factor factor, Map<Factor, double[]> where, Optional<String> at) {
    List<PairwiseComparison> family = new ArrayList<>();
    int levels = factor.levels().size();
    for (int a = 0; a < levels; a++) {
      for (int b = a + 1; b < levels; b++) {
        Map<Factor, double[]> weights = new LinkedHashMap<>(where);
        weights.put(factor, difference(factor, a, b));
        String first = factor.levels().get(a);
        String second = factor.levels().get(b);
        family.add(comparison(factor.name(), at, first, second, weights, levels));
      }
    }
    return adjusted(family);
  }

  /**
   * Returns the interaction contrasts: the difference of two levels of the other factor at one
   * level, less that difference at another level.
   */
  private List<PairwiseComparison> interactions(Factor one, Factor other) {
    boolean swapped = design.withinFactors().contains(other);
    boolean alike = design.withinFactors().contains(one) == swapped;
    String name =
        swapped && !alike ? other.name() + " x " + one.name() : one.name() + " x " + other.name();
    List<PairwiseComparison> family = new ArrayList<>();
    for (int a = 0; a < one.levels().size(); a++) {
      for (int b = a + 1; b < one.levels().size(); b++) {
        for (int j = 0; j < other.levels().size(); j++) {
          for (int k = j + 1; k < other.levels().size(); k++) {
            String pair = " (" + other.levels().get(j) + " − " + other.levels().get(k) + ")";
            family.add(
                comparison(
                    name,
                    Optional.empty(),
                    one.levels().get(a) + pair,
                    one.levels().get(b) + pair,
                    Map.of(one, difference(one, a, b), other, difference(other, j, k)),
                    0));
          }
        }
      }
    }
    return adjusted(family);
  }

  private PairwiseComparison comparison(
      String factor,
      Optional<String> at,
      String first,
      String second,
      Map<Factor, double[]> weights,
      int means) {
    RealVector groups = weights(design.betweenFactors(), weights);
    RealVector within = weights(design.withinFactors(), weights);
    double difference = estimate(groups, within);
    double error = standardError(groups, within);
    double df = cells.errorDf();
    // Where all scores are equal, the difference is rounding error and t is undefined.
    boolean constant = error <= 1e-10 * Math.max(Math.abs(difference), deviation);
    double t = constant ? Double.NaN : difference / error;
    double none = Double.NaN;
    return new PairwiseComparison(
        factor,
        at,
        first,
        second,
        difference,
        error,
        df,
        difference - half * error,
        difference + half * error,
        t,
        constant ? none : TailProbabilities.tTwoSided(t, df),
        new PairwiseComparison.Family(1, means, none),
        deviation,
        options.confidence(),
        constant ? new Tost(bound(), none, none, none) : Tost.of(difference, error, df, bound()),
        1 / spread(groups),
        options.priorScale());
  }

  private static List<PairwiseComparison> adjusted(List<PairwiseComparison> family) {
    double[] holm = HolmCorrection.adjusted(family.stream().map(PairwiseComparison::p).toList());
    for (int i = 0; i < holm.length; i++) {
      family.set(i, family.get(i).inFamily(family.size(), holm[i]));
    }
    return family;
  }

  private static double[] at(Factor factor, int level) {
    double[] weights = new double[factor.levels().size()];
    weights[level] = 1;
    return weights;
  }

  private static double[] difference(Factor factor, int first, int second) {
    double[] weights = at(factor, first);
    weights[second] = -1;
    return weights;
  }

  /**
   * Returns weights over the combinations of levels; a factor that is not mentioned has equal
   * weights.
   */
  private static RealVector weights(List<Factor> factors, Map<Factor, double[]> mentioned) {
    double[] all = {1};
    for (Factor factor : factors) {
      int levels = factor.levels().size();
      double[] equal = new double[levels];
      Arrays.fill(equal, 1.0 / levels);
      double[] own = mentioned.getOrDefault(factor, equal);
      double[] longer = new double[all.length * levels];
      for (int i = 0; i < longer.length; i++) {
        longer[i] = all[i / levels] * own[i % levels];
      }
      all = longer;
    }
    return MatrixUtils.createRealVector(all);
  }

  private double estimate(RealVector groups, RealVector within) {
    double sum = 0;
    for (int group = 0; group < cells.groups(); group++) {
      double weight = groups.getEntry(group);
      if (weight != 0) {
        sum += weight * MatrixUtils.createRealVector(cells.means(group)).dotProduct(within);
      }
    }
    return sum;
  }

  /** Returns u' (X'X)^-1 u, the reciprocal of the effective number of subjects of such a mean. */
  private double spread(RealVector groups) {
    RealMatrix inverse = cells.inverse().getSubMatrix(0, cells.groups() - 1, 0, cells.groups() - 1);
    return groups.dotProduct(inverse.operate(groups));
  }

  private double standardError(RealVector groups, RealVector within) {
    double variance = within.dotProduct(covariance.operate(within));
    return Math.sqrt(Math.max(0, variance * spread(groups)));
  }
}
