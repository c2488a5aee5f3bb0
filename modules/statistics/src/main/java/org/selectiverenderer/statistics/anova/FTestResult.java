package org.selectiverenderer.statistics.anova;

import java.util.Optional;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * The F test of an effect. A value that is not defined is NaN.
 *
 * @param f mean square of the effect divided by that of its error
 * @param df1 degrees of freedom of the effect, after any sphericity correction
 * @param df2 degrees of freedom of the error, after any sphericity correction
 * @param p of F with these degrees of freedom
 * @param sphericity Mauchly's test and epsilons, for effects on three or more within levels
 * @param correction the sphericity correction, if any
 */
public record FTestResult(
    Term term,
    double f,
    double df1,
    double df2,
    double p,
    Optional<Sphericity> sphericity,
    Optional<CorrectedDegreesOfFreedom> correction) {
  /**
   * An error sum of squares below these shares of the scores' size and spread is rounding error.
   */
  private static final double SIZE_ROUNDING = 1e-20;

  private static final double SPREAD_ROUNDING = 1e-13;

  static FTestResult of(
      Term term, LinearHypothesis h, MultivariateLinearModel cells, AnovaOptions options) {
    double size = 0;
    for (int group = 0; group < cells.groups(); group++) {
      for (double mean : cells.means(group)) {
        size += mean * mean * cells.size(group);
      }
    }
    boolean constant =
        h.errorSum() <= SIZE_ROUNDING * size + SPREAD_ROUNDING * cells.error().getTrace();
    double f = constant ? Double.NaN : h.sum() / h.df1() / (h.errorSum() / h.df2());
    Optional<Sphericity> sphericity =
        h.dimensions() > 1 && !term.within().isEmpty() && !constant
            ? Optional.of(Sphericity.of(h))
            : Optional.empty();
    Optional<CorrectedDegreesOfFreedom> correction =
        sphericity.flatMap(
            found -> options.sphericity().corrected(found, h.df1(), h.df2(), options.alpha()));
    double df1 = correction.map(CorrectedDegreesOfFreedom::df1).orElse(h.df1());
    double df2 = correction.map(CorrectedDegreesOfFreedom::df2).orElse(h.df2());
    return new FTestResult(
        term,
        f,
        df1,
        df2,
        constant ? Double.NaN : TailProbabilities.f(f, df1, df2),
        sphericity,
        correction);
  }

  /** Returns whether the error has no variance, so that F is undefined. */
  boolean constant() {
    return Double.isNaN(f);
  }
}
