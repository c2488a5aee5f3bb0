package org.selectiverenderer.statistics.apa;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.study.AreaAnalysis;
import org.selectiverenderer.statistics.study.MultipleTestingCorrection;
import org.selectiverenderer.statistics.study.StudyAnalysis;

/**
 * Writes the results of tests as sentences for a manuscript. They report results and do not
 * interpret them.
 */
public final class ApaSentences {
  private ApaSentences() {}

  /** Returns {@code F(2, 51) = 2.32, p = .109, ηp² = .08, 90% CI [.00, .19]}. */
  public static String test(Effect effect) {
    if (!Double.isFinite(effect.f())) {
      return "no F is defined" + effect.flaw().map(flaw -> " (" + flaw + ")").orElse("");
    }
    String size =
        Double.isFinite(effect.partialEta().value())
            ? ", ηp² = %s, %s%% CI %s"
                .formatted(
                    ApaNumberFormat.share(effect.partialEta().value(), 2),
                    ApaNumberFormat.of(100 * effect.partialEta().confidence(), 0),
                    ApaNumberFormat.interval(
                        effect.partialEta().low(), effect.partialEta().high(), 2))
            : "";
    return "F(%s, %s) = %s, %s%s"
        .formatted(
            ApaNumberFormat.df(effect.testDf1()),
            ApaNumberFormat.df(effect.testDf2()),
            ApaNumberFormat.of(effect.f(), 2),
            ApaNumberFormat.withP("p", effect.p()),
            size);
  }

  /** Returns a sentence for each effect of an area at a level of confidence. */
  public static List<String> of(StudyAnalysis study, String area, ConfidenceThreshold level) {
    List<String> sentences = new ArrayList<>();
    study
        .analyses(area)
        .filter(analysis -> analysis.level() == level)
        .forEach(analysis -> add(study, analysis, sentences));
    return sentences;
  }

  private static void add(StudyAnalysis study, AreaAnalysis analysis, List<String> sentences) {
    String where =
        "%s (%s, %s, n = %d)"
            .formatted(
                analysis.measure().symbol(),
                analysis.area(),
                analysis.level().title(),
                analysis.design().subjects().size());
    if (analysis.anova().isEmpty() || analysis.evidence().isEmpty()) {
      sentences.add(where + " was not analysed: " + analysis.design().obstacle().orElse("") + ".");
      return;
    }
    for (EffectBayesFactors evidence : analysis.evidence().get().effects()) {
      Effect effect = evidence.of(analysis.anova().get());
      sentences.add(sentence(study, analysis, effect, evidence, where));
    }
  }

  private static String sentence(
      StudyAnalysis study,
      AreaAnalysis analysis,
      Effect effect,
      EffectBayesFactors evidence,
      String where) {
    if (!Double.isFinite(effect.f())) {
      return "For %s, %s: %s.".formatted(where, name(effect), test(effect));
    }
    boolean corrected = study.family() != MultipleTestingCorrection.NONE;
    double p = corrected ? study.adjusted(analysis, effect) : effect.p();
    StringBuilder text = new StringBuilder();
    text.append("For ").append(where).append(", ").append(name(effect));
    text.append(p < study.options().alpha() ? " was" : " was not");
    text.append(" significant, ").append(test(effect));
    if (corrected) {
      text.append(", ").append(ApaNumberFormat.withP("p corrected over the study", p));
    }
    text.append("; equivalence (ηp² < ")
        .append(ApaNumberFormat.share(study.options().etaBound(), 2));
    text.append("): ").append(ApaNumberFormat.withP("p", effect.equivalence().p()));
    text.append("; BF01 = ").append(ApaNumberFormat.bayes(evidence.bf01())).append('.');
    return text.toString();
  }

  private static String name(Effect effect) {
    return effect.name().contains(" x ")
        ? "the interaction " + effect.name().replace(" x ", " × ")
        : "the effect of " + effect.name();
  }
}
