package org.selectiverenderer.statistics.anova;

import java.util.Optional;
import org.selectiverenderer.statistics.distribution.Tails;

/**
 * The F of an effect and its p. What is not defined is not a number.
 *
 * @param f mean square of the effect over that of its error
 * @param df1 of the test: corrected for a lack of sphericity where that is done
 * @param df2 as df1
 * @param p of F with those
 * @param sphericity of effects on three or more within levels
 * @param correction of the degrees of freedom, where there is one
 */
public record EffectTest(
    Term term,
    double f,
    double df1,
    double df2,
    double p,
    Optional<Sphericity> sphericity,
    Optional<CorrectedDf> correction) {
  /** Below these shares of the scores' size and spread an error's sum of squares is rounding. */
  private static final double SIZE_ROUNDING = 1e-20;

  private static final double SPREAD_ROUNDING = 1e-13;

  static EffectTest of(Term term, Hypothesis h, CellStatistics cells, AnovaOptions options) {
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
    Optional<CorrectedDf> correction =
        sphericity.flatMap(
            found -> options.sphericity().corrected(found, h.df1(), h.df2(), options.alpha()));
    double df1 = correction.map(CorrectedDf::df1).orElse(h.df1());
    double df2 = correction.map(CorrectedDf::df2).orElse(h.df2());
    return new EffectTest(
        term, f, df1, df2, constant ? Double.NaN : Tails.f(f, df1, df2), sphericity, correction);
  }

  /** Whether the error has no variance, so that there is no F. */
  boolean constant() {
    return Double.isNaN(f);
  }
}
