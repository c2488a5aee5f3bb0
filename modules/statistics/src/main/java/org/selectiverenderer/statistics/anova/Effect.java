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
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * A row of the ANOVA table. A value that is not defined is NaN; {@link #flaw} says why.
 *
 * @param df1 degrees of freedom of the effect, uncorrected
 * @param df2 degrees of freedom of the error, uncorrected
 * @param f mean square of the effect divided by that of its error
 * @param correction the sphericity correction of the degrees of freedom, if any: p, the intervals
 *     and the equivalence test then use the corrected degrees of freedom
 * @param p of F with {@link #testDf1} and {@link #testDf2} degrees of freedom
 * @param partialEta partial eta squared; without an interval for the intercept, whose effect size
 *     has no meaning
 * @param omega partial omega squared
 * @param sphericity Mauchly's test and epsilons, for effects on three or more within levels
 * @param multivariate multivariate tests, for effects on within levels, in the order of {@link
 *     MultivariateStatistic}
 * @param flaw why a value is not defined, as a sentence without its full stop
 */
public record Effect(
    Term term,
    double ss,
    double errorSs,
    double df1,
    double df2,
    double f,
    Optional<CorrectedDegreesOfFreedom> correction,
    double p,
    EffectSize partialEta,
    EffectSize generalisedEta,
    EffectSize omega,
    Optional<Sphericity> sphericity,
    List<MultivariateTest> multivariate,
    OmnibusEquivalenceTest equivalence,
    Optional<String> flaw) {
  /** Makes defensive copies, so that the record is immutable. */
  public Effect {
    multivariate = List.copyOf(multivariate);
  }

  /** Returns the names of the factors, joined by {@code x}, within factors first. */
  public String name() {
    return term.name();
  }

  /** Returns the kind of effect. */
  public EffectKind kind() {
    return term.kind();
  }

  /** Returns the mean square of the effect. */
  public double ms() {
    return ss / df1;
  }

  /** Returns the mean square of the error. */
  public double errorMs() {
    return errorSs / df2;
  }

  /** Returns the effect's degrees of freedom in the test, after any sphericity correction. */
  public double testDf1() {
    return correction.map(CorrectedDegreesOfFreedom::df1).orElse(df1);
  }

  /** Returns the error's degrees of freedom in the test, after any sphericity correction. */
  public double testDf2() {
    return correction.map(CorrectedDegreesOfFreedom::df2).orElse(df2);
  }

  /** Returns p with the degrees of freedom multiplied by an epsilon of {@link Sphericity}. */
  public double correctedP(double epsilon) {
    return Double.isFinite(f) ? TailProbabilities.f(f, df1 * epsilon, df2 * epsilon) : Double.NaN;
  }

  /** Returns p without a sphericity correction. */
  public double uncorrectedP() {
    return correctedP(1);
  }

  static Effect of(
      Term term, FactorialDesign design, MultivariateLinearModel cells, AnovaOptions options) {
    LinearHypothesis h = LinearHypothesis.of(term, design, cells);
    FTestResult test = FTestResult.of(term, h, cells, options);
    boolean constant = test.constant();
    boolean contrasts = !term.within().isEmpty();
    EffectSizeEstimator sizes =
        new EffectSizeEstimator(
            h, test.f(), test.df1(), test.df2(), cells, options.etaConfidence());
    boolean bounds = !constant && term.kind() != EffectKind.INTERCEPT;
    NoncentralF.Interval noncentrality =
        bounds ? sizes.noncentrality() : new NoncentralF.Interval(Double.NaN, Double.NaN);
    List<MultivariateTest> multivariate = contrasts && !constant ? multivariate(h) : List.of();
    return new Effect(
        term,
        h.sum(),
        h.errorSum(),
        h.df1(),
        h.df2(),
        test.f(),
        test.correction(),
        test.p(),
        constant ? undefined(options) : sizes.partialEta(noncentrality),
        constant ? undefined(options) : sizes.generalisedEta(noncentrality),
        constant ? undefined(options) : sizes.omega(noncentrality),
        test.sphericity(),
        multivariate,
        OmnibusEquivalenceTest.of(test.f(), test.df1(), test.df2(), options.etaBound()),
        flaw(constant, contrasts && multivariate.isEmpty()));
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

  /** Returns the multivariate tests; empty when the error matrix is singular. */
  private static List<MultivariateTest> multivariate(LinearHypothesis h) {
    Optional<double[]> roots = roots(h);
    List<MultivariateTest> tests = new ArrayList<>();
    if (roots.isPresent()) {
      for (MultivariateStatistic statistic : MultivariateStatistic.values()) {
        tests.add(statistic.test(roots.get(), h.dimensions(), h.effectDf(), h.errorDf()));
      }
    }
    return tests;
  }

  /**
   * Returns the eigenvalues of E^-1 H, computed as those of the symmetric L^-1 H L^-T with E = L
   * L^T.
   */
  private static Optional<double[]> roots(LinearHypothesis h) {
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

  /**
   * The equivalence test of an effect: the hypothesis that its partial eta squared is at least the
   * bound is rejected when F is small enough, p = P(F &le; f) with noncentrality bound / (1 -
   * bound) (df1 + df2 + 1) (Campbell and Lakens 2021, British Journal of Mathematical and
   * Statistical Psychology 74; Wellek 2010, Testing Statistical Hypotheses of Equivalence and
   * Noninferiority, 9.2).
   *
   * @param bound equivalence bound of the partial eta squared
   * @param p below alpha, the effect is smaller than the bound
   */
  public record OmnibusEquivalenceTest(double bound, double p) {
    static OmnibusEquivalenceTest of(double f, double df1, double df2, double bound) {
      double noncentrality = bound / (1 - bound) * (df1 + df2 + 1);
      double p =
          Double.isFinite(f) ? new NoncentralF(df1, df2).cumulative(f, noncentrality) : Double.NaN;
      return new OmnibusEquivalenceTest(bound, p);
    }
  }
}
