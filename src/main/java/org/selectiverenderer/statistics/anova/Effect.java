package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.selectiverenderer.statistics.distribution.NoncentralF;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * A row of a table of F. What is not defined is not a number; {@link #flaw} says why.
 *
 * @param name the factor's, or {@code within x between}
 * @param f mean square of the effect over that of its error
 * @param sphericity of effects on three or more within levels
 * @param multivariate of effects on within levels, in the order of {@link MultivariateStatistic}
 * @param bayesFactor BF01 from BIC
 * @param flaw why something is not defined: a sentence without its full stop
 */
public record Effect(
    EffectKind kind,
    String name,
    double ss,
    double errorSs,
    double df1,
    double df2,
    double f,
    double p,
    EffectSize partialEta,
    EffectSize generalisedEta,
    Optional<Sphericity> sphericity,
    List<MultivariateTest> multivariate,
    OmnibusEquivalence equivalence,
    double bayesFactor,
    Optional<String> flaw) {
  /** Below these shares of the scores' size and spread an error's sum of squares is rounding. */
  private static final double SIZE_ROUNDING = 1e-20;

  private static final double SPREAD_ROUNDING = 1e-13;

  public Effect {
    multivariate = List.copyOf(multivariate);
  }

  /** Mean square. */
  public double ms() {
    return ss / df1;
  }

  /** Mean square of the error. */
  public double errorMs() {
    return errorSs / df2;
  }

  /** p with degrees of freedom multiplied by an epsilon of {@link Sphericity}. */
  public double correctedP(double epsilon) {
    return Double.isFinite(f) ? Tails.f(f, df1 * epsilon, df2 * epsilon) : Double.NaN;
  }

  static Effect of(EffectKind kind, String name, CellStatistics cells, AnovaOptions options) {
    Hypothesis h = Hypothesis.of(kind, cells);
    double size = 0;
    for (int group = 0; group < cells.groups(); group++) {
      for (double mean : cells.means(group)) {
        size += mean * mean * cells.size(group);
      }
    }
    boolean constant =
        h.errorSum() <= SIZE_ROUNDING * size + SPREAD_ROUNDING * cells.error().getTrace();
    double f = constant ? Double.NaN : h.sum() / h.df1() / (h.errorSum() / h.df2());
    EtaSquared eta = new EtaSquared(cells, options.etaConfidence());
    NoncentralF.Interval noncentrality = eta.noncentrality(h, f);
    List<MultivariateTest> multivariate =
        kind.ofContrasts() && !constant ? multivariate(h) : List.of();
    boolean singular = kind.ofContrasts() && multivariate.isEmpty();
    double independent = (double) cells.subjects() * h.dimensions();
    return new Effect(
        kind,
        name,
        h.sum(),
        h.errorSum(),
        h.df1(),
        h.df2(),
        f,
        constant ? Double.NaN : Tails.f(f, h.df1(), h.df2()),
        constant ? undefined(options) : eta.partial(h, noncentrality),
        constant ? undefined(options) : eta.generalised(h, noncentrality),
        h.dimensions() > 1 && kind.ofContrasts() && !constant
            ? Optional.of(Sphericity.of(h))
            : Optional.empty(),
        multivariate,
        OmnibusEquivalence.of(f, h.df1(), h.df2(), options.etaBound()),
        constant ? Double.NaN : BayesFactors.bic(h.sum(), h.errorSum(), h.df1(), independent),
        flaw(constant, singular));
  }

  private static Optional<String> flaw(boolean constant, boolean singular) {
    if (constant) {
      return Optional.of(
          "the error has zero variance: every participant of a group has the same value, so there is"
              + " no F");
    }
    return singular
        ? Optional.of(
            "the multivariate tests need more participants, or levels that do not "
                + "depend on each other")
        : Optional.empty();
  }

  private static EffectSize undefined(AnovaOptions options) {
    return new EffectSize(Double.NaN, Double.NaN, Double.NaN, options.etaConfidence());
  }

  /** Empty when the error's matrix cannot be inverted. */
  private static List<MultivariateTest> multivariate(Hypothesis h) {
    Optional<double[]> roots = roots(h);
    List<MultivariateTest> tests = new ArrayList<>();
    if (roots.isPresent()) {
      for (MultivariateStatistic statistic : MultivariateStatistic.values()) {
        tests.add(statistic.test(roots.get(), h.dimensions(), h.effectDf(), h.errorDf()));
      }
    }
    return tests;
  }

  /** Eigenvalues of E^-1 H, as those of the symmetric L^-1 H L^-T with E = L L^T. */
  private static Optional<double[]> roots(Hypothesis h) {
    double[] spread = new EigenDecomposition(h.error()).getRealEigenvalues();
    double largest = Arrays.stream(spread).max().orElse(0);
    double smallest = Arrays.stream(spread).min().orElse(0);
    if (h.errorDf() < h.dimensions() || smallest <= 1e-12 * largest) {
      return Optional.empty();
    }
    RealMatrix l = new CholeskyDecomposition(h.error(), 1e-9, 0).getL();
    RealMatrix inverse = MatrixUtils.inverse(l);
    RealMatrix symmetric = inverse.multiply(h.effect()).multiply(inverse.transpose());
    symmetric = symmetric.add(symmetric.transpose()).scalarMultiply(0.5);
    return Optional.of(
        Arrays.stream(new EigenDecomposition(symmetric).getRealEigenvalues())
            .map(root -> Math.max(0, root))
            .toArray());
  }
}
