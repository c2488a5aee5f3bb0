package org.selectiverenderer.statistics.report;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;

/** Writes the methods section of a report: what was computed and how. */
final class MethodsNotes {
  private MethodsNotes() {}

  static List<String> of(DetectionScorer scoring) {
    return List.of(
        "Hits, misses, false alarms and correct rejections are counted per participant, area and"
            + " object type. d′ = z(H) − z(FA); log β = (z(FA)² − z(H)²)/2, natural logarithm; c ="
            + " −(z(H) + z(FA))/2. Positive log β and c: a bias towards “no”.",
        "Correction of rates: " + scoring.correction().description() + ".",
        "Confidence: all answers, those with confidence 3 to 5, those with confidence 5 (“un”, “mod” and"
            + " “high” in the thesis, whose condition high is another thing); "
            + (scoring.guessing() == LowConfidencePolicy.DISCARD
                ? "answers below a level are left out."
                : "answers below a level count as “no”."));
  }

  static String of(MultipleTestingCorrection family) {
    return family == MultipleTestingCorrection.NONE
        ? "Tests of the study: p of effects is not corrected across measures, areas and levels of"
            + " confidence; of effects that do not exist, a share of α comes out below α. --family"
            + " corrects."
        : "Tests of the study: “p corrected” holds for all effects on all measures in all areas at"
            + " one level of confidence together: "
            + family.title()
            + ". Intervals, equivalence and Bayes factors are not corrected.";
  }

  static List<String> of(AnovaOptions options) {
    String bound =
        options.rawBound()
            ? "±%s in the measure's units".formatted(number(options.differenceBound()))
            : "±%s pooled standard deviations of a cell"
                .formatted(number(options.differenceBound()));
    return List.of(
        "Analysis of variance with type III sums of squares. " + sphericity(options),
        ("Intervals: %s %% for means and differences, %s %% for η² (noncentral F; Steiger 2004; they"
                + " are of the population's value and lie below the sample's where F is very"
                + " small).")
            .formatted(percent(options.confidence()), percent(options.etaConfidence())),
        "Comparisons use the pooled error of the multivariate model; p (Holm), p (Bonf.) and p (Tukey)"
            + " keep each family of comparisons at α = "
            + number(options.alpha())
            + ".",
        "A p above α does not show that there is no difference. The report therefore "
            + "gives: TOST with bounds "
            + bound
            + " (Schuirmann 1987), its counterpart for effects with the bound ηp² < "
            + number(options.etaBound())
            + " (Campbell and Lakens 2021), and Bayes factors for the null hypothesis (BF01 > 1"
            + " speaks for it).",
        ("Bayes factors are of Jeffreys, Zellner and Siow. Of effects (Rouder et al. 2012): a model of"
                + " all effects that do not contain the one tested, against the same and it; “alone”"
                + " has in both models only the effects that it contains (an interaction's main"
                + " effects). The prior's width is %s for effects and, where there are within factors,"
                + " %s for participants, who are a random factor of every model. They assume"
                + " sphericity. Of comparisons (Rouder et al. 2009): width %s.")
            .formatted(
                number(options.prior().fixed()),
                number(options.prior().random()),
                number(options.priorScale())));
  }

  private static String sphericity(AnovaOptions options) {
    String rule =
        switch (options.sphericity()) {
          case AUTO ->
              ("degrees of freedom are multiplied by ε where Greenhouse-Geisser's ε is at most 0.75 or"
                      + " Mauchly's test has p < %s: by Greenhouse-Geisser's ε up to 0.75, else by"
                      + " Huynh-Feldt's (Lecoutre)")
                  .formatted(number(options.alpha()));
          case GREENHOUSE_GEISSER -> "degrees of freedom are multiplied by Greenhouse-Geisser's ε";
          case HUYNH_FELDT -> "degrees of freedom are multiplied by Huynh-Feldt's ε (Lecoutre)";
          case NONE -> "degrees of freedom are not corrected for a lack of sphericity";
        };
    return "For effects on three or more within levels %s; p, intervals and equivalence tests are of"
            .formatted(rule)
        + " those degrees of freedom. The multivariate tests, which need no sphericity, are given"
        + " beside F.";
  }

  private static String percent(double share) {
    return number(100 * share);
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.3f", value).replaceFirst("\\.?0+$", "");
  }
}
