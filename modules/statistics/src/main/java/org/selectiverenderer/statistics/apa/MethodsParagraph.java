package org.selectiverenderer.statistics.apa;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Writes the methods paragraph of a manuscript with its references. It names only what was
 * computed.
 */
public final class MethodsParagraph {
  private static final String EFFECT_BAYES_SOURCE =
      "Rouder, J. N., Morey, R. D., Speckman, P. L., & Province, J. M. (2012). Default Bayes factors"
          + " for ANOVA designs. Journal of Mathematical Psychology, 56(5), 356–374.";

  private final StudyAnalysis study;
  private final String program;
  private final TreeSet<String> references = new TreeSet<>();

  /**
   * @param program the program's name with its version
   */
  public MethodsParagraph(StudyAnalysis study, String program) {
    this.study = study;
    this.program = program;
  }

  /** Returns the paragraph. */
  public String text() {
    List<String> sentences = new ArrayList<>();
    sentences.add(
        "Answers of %s were analysed with %s (Java %s)."
            .formatted(
                Pluralizer.of(study.participants().size(), "participant"),
                program,
                Runtime.version().feature()));
    sentences.add(detection());
    sentences.add(levels());
    sentences.add(variance());
    sentences.add(absence());
    sentences.add(many());
    sentences.add(ratings());
    return String.join(" ", sentences);
  }

  /** Returns the references that the paragraph cites, in alphabetical order. */
  public List<String> references() {
    references.clear();
    text();
    return List.copyOf(references);
  }

  private String detection() {
    references.add(
        "Macmillan, N. A., & Creelman, C. D. (2005). Detection theory: A user's guide (2nd ed.)."
            + " Erlbaum.");
    String correction =
        switch (study.scoring().correction()) {
          case LOG_LINEAR -> {
            references.add(
                "Hautus, M. J. (1995). Corrections for extreme proportions and their biasing"
                    + " effects on estimated values of d′. Behavior Research Methods, Instruments,"
                    + " & Computers, 27(1), 46–51.");
            yield "with the log-linear correction of all rates (Hautus, 1995)";
          }
          case HALF_TRIAL -> {
            references.add(
                "Macmillan, N. A., & Kaplan, H. L. (1985). Detection theory analysis of group data:"
                    + " Estimating sensitivity from average hit and false-alarm rates."
                    + " Psychological Bulletin, 98(1), 185–199.");
            yield "with rates of 0 and 1 replaced by 1/(2N) and 1 − 1/(2N) (Macmillan & Kaplan,"
                + " 1985)";
          }
          case NONE -> "without a correction of rates of 0 and 1, which have no score";
        };
    return "Sensitivity d′, bias log β and criterion c were computed for each participant, area and"
        + " type of object from hit and false alarm rates (Macmillan & Creelman, 2005), "
        + correction
        + ".";
  }

  private String levels() {
    return "This was done for all answers, for those with a confidence of 3 to 5 and for those with"
        + " a confidence of 5; answers below a level "
        + (study.scoring().guessing() == LowConfidencePolicy.DISCARD
            ? "were left out."
            : "counted as “no”.");
  }

  private String variance() {
    references.add(
        "Steiger, J. H. (2004). Beyond the F test: Effect size confidence intervals and tests of"
            + " close fit in the analysis of variance and contrast analysis. Psychological Methods,"
            + " 9(2), 164–182.");
    references.add(
        "Holm, S. (1979). A simple sequentially rejective multiple test procedure. Scandinavian"
            + " Journal of Statistics, 6(2), 65–70.");
    return "The scores of each area were submitted to analyses of variance (type III sums of squares)"
        + " with the condition between and the type of object within participants; intervals of ηp²"
        + " are by the noncentral F distribution (Steiger, 2004), and comparisons are corrected"
        + " after Holm (1979).";
  }

  private String absence() {
    references.add(
        "Campbell, H., & Lakens, D. (2021). Can we disregard the whole model? Omnibus"
            + " non-inferiority testing for R² in multi-variable linear regression and η̂² in ANOVA."
            + " British Journal of Mathematical and Statistical Psychology, 74(1), 64–89.");
    references.add(
        "Schuirmann, D. J. (1987). A comparison of the two one-sided tests procedure and the power"
            + " approach for assessing the equivalence of average bioavailability. Journal of"
            + " Pharmacokinetics and Biopharmaceutics, 15(6), 657–680.");
    references.add(EFFECT_BAYES_SOURCE);
    references.add(
        "Rouder, J. N., Speckman, P. L., Sun, D., Morey, R. D., & Iverson, G. (2009). Bayesian t"
            + " tests for accepting and rejecting the null hypothesis. Psychonomic Bulletin &"
            + " Review, 16(2), 225–237.");
    return ("The absence of effects was tested against ηp² < %s (Campbell & Lakens, 2021), that of"
            + " differences by two one-sided tests with bounds of ±%s %s (Schuirmann, 1987); Bayes"
            + " factors for the null hypothesis have Jeffreys-Zellner-Siow priors of scale %s for"
            + " effects (Rouder et al., 2012) and %s for comparisons (Rouder et al., 2009).")
        .formatted(
            ApaNumberFormat.share(study.options().etaBound(), 2),
            ApaNumberFormat.of(study.options().differenceBound(), 2),
            study.options().rawBound() ? "in the measure's units" : "standard deviations",
            ApaNumberFormat.of(study.options().prior().fixed(), 2),
            ApaNumberFormat.of(study.options().priorScale(), 3));
  }

  private String many() {
    if (study.family() == MultipleTestingCorrection.NONE) {
      return "p was not corrected over areas, measures and levels of confidence.";
    }
    if (study.family() == MultipleTestingCorrection.FDR) {
      references.add(
          "Benjamini, Y., & Hochberg, Y. (1995). Controlling the false discovery rate: A practical"
              + " and powerful approach to multiple testing. Journal of the Royal Statistical"
              + " Society: Series B, 57(1), 289–300.");
    }
    return "p was corrected over all effects on all measures in all areas at a level of confidence ("
        + (study.family() == MultipleTestingCorrection.FDR
            ? "false discovery rate; Benjamini & Hochberg, 1995)."
            : "Holm, 1979).");
  }

  private String ratings() {
    references.add(
        "Dorfman, D. D., & Alf, E., Jr. (1969). Maximum-likelihood estimation of parameters of"
            + " signal-detection theory and determination of confidence intervals—rating-method"
            + " data. Journal of Mathematical Psychology, 6(3), 487–496.");
    references.add(
        "DeLong, E. R., DeLong, D. M., & Clarke-Pearson, D. L. (1988). Comparing the areas under two"
            + " or more correlated receiver operating characteristic curves: A nonparametric"
            + " approach. Biometrics, 44(3), 837–845.");
    return "Confidence ratings pooled over the participants of a condition gave the area under the"
        + " ROC (standard errors after DeLong et al., 1988) and, by maximum likelihood under"
        + " unequal variances (Dorfman & Alf, 1969), d_a, A_z and the slope of the ROC.";
  }
}
