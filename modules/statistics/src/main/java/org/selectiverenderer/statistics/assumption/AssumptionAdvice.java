package org.selectiverenderer.statistics.assumption;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.CorrectedDegreesOfFreedom;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.SphericityCorrection;

/** Words the consequences of the assumption checks for the analysis. */
final class AssumptionAdvice {
  /**
   * The customary significance level of Box's M, which detects even trivial differences in large
   * samples.
   */
  private static final double BOX_LEVEL = 0.001;

  /** Group sizes whose ratio is below this count as nearly equal. */
  private static final double NEARLY_EQUAL = 1.5;

  /** With this many error degrees of freedom, F is robust to non-normal scores. */
  private static final double ENOUGH = 30;

  private final Anova anova;
  private final AssumptionChecks found;
  private final double alpha;
  private final List<String> sentences = new ArrayList<>();

  private AssumptionAdvice(Anova anova, AssumptionChecks found) {
    this.anova = anova;
    this.found = found;
    alpha = anova.options().alpha();
  }

  static List<String> of(Anova anova, AssumptionChecks found) {
    AssumptionAdvice made = new AssumptionAdvice(anova, found);
    made.variances();
    made.covariances();
    made.sphericity();
    made.normality();
    made.outliers();
    if (made.sentences.isEmpty()) {
      made.sentences.add("No check indicates a violated assumption.");
    }
    return made.sentences;
  }

  private boolean alike() {
    int[] sizes = new int[anova.design().between().levels().size()];
    anova.design().subjects().forEach(subject -> sizes[subject.group()]++);
    return Arrays.stream(sizes).max().orElse(1)
        <= NEARLY_EQUAL * Arrays.stream(sizes).min().orElse(1);
  }

  private void variances() {
    List<LeveneTest> violated = found.levene().stream().filter(test -> test.p() < alpha).toList();
    if (violated.isEmpty()) {
      return;
    }
    String where = where(violated.stream().map(LeveneTest::at).toList());
    String welch =
        found
            .welch()
            .filter(test -> Double.isFinite(test.p()))
            .map(
                test ->
                    (" Welch's F of the groups, which does not assume equal variances:"
                            + " F(%s, %s) = %s, p %s.")
                        .formatted(
                            number(test.df1(), 0),
                            number(test.df2(), 2),
                            number(test.f(), 3),
                            p(test.p())))
            .orElse("");
    sentences.add(
        "The groups' variances differ%s (Levene). %s%s"
            .formatted(
                where,
                alike()
                    ? "With groups of nearly equal size, as here, F is robust."
                    : "The groups' sizes differ too, so p of between effects may be too small or"
                        + " too large.",
                welch));
  }

  private void covariances() {
    if (found.box().filter(test -> test.p() < BOX_LEVEL).isPresent()) {
      sentences.add(
          "The groups' covariances differ (Box's M). "
              + (alike()
                  ? "With groups of nearly equal size, Pillai's trace is robust: prefer it among"
                      + " the multivariate tests."
                  : "With groups of such different size neither the multivariate tests nor F of"
                      + " interactions with the groups can be trusted near the level of"
                      + " significance."));
    }
  }

  private void sphericity() {
    for (Effect effect : anova.effects()) {
      Optional<CorrectedDegreesOfFreedom> correction = effect.correction();
      if (correction.isPresent()) {
        boolean gg = correction.get().by() == SphericityCorrection.GREENHOUSE_GEISSER;
        sentences.add(
            "%s: degrees of freedom are multiplied by ε = %s (%s); without it p %s."
                .formatted(
                    effect.name(),
                    number(correction.get().epsilon(), 3),
                    gg ? "Greenhouse-Geisser" : "Huynh-Feldt",
                    p(effect.uncorrectedP())));
      } else if (effect.sphericity().filter(test -> test.mauchlyP() < alpha).isPresent()) {
        sentences.add(
            effect.name()
                + ": sphericity does not hold (Mauchly), and its p is not corrected: it may be too"
                + " small.");
      }
    }
  }

  private void normality() {
    List<ShapiroWilkTest> violated =
        found.shapiro().stream().filter(test -> test.p() < alpha).toList();
    if (!violated.isEmpty()) {
      sentences.add(
          "Residuals are not normally distributed%s (Shapiro-Wilk). %s"
              .formatted(
                  where(violated.stream().map(ShapiroWilkTest::at).toList()),
                  anova.intercept().df2() >= ENOUGH
                      ? "With this many participants F depends little on it; look for outliers and"
                          + " skew."
                      : "With few participants, p is only approximate: look at the plots, and"
                          + " consider a transformation of the measure or a rank-based test."));
    }
  }

  private void outliers() {
    if (!found.outliers().isEmpty()) {
      String who =
          found.outliers().stream()
              .map(
                  outlier ->
                      outlier.participant() + outlier.at().map(level -> " at " + level).orElse(""))
              .collect(Collectors.joining(", "));
      sentences.add(
          "Outliers: %s. Check their records, and report the analysis with and without them."
              .formatted(who));
    }
  }

  private static String where(List<Optional<String>> levels) {
    String names = levels.stream().flatMap(Optional::stream).collect(Collectors.joining(", "));
    return names.isEmpty() ? "" : " at " + names;
  }

  private static String p(double value) {
    return value < 0.001 ? "< 0.001" : "= " + number(value, 3);
  }

  private static String number(double value, int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}
