package org.selectiverenderer.statistics.study;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Reports effects that cannot be tested although every answer is valid, for example because there
 * are too few participants or all scores are equal. The report of the study has footnotes about
 * them; this class also reports them as problems, once for each area and only for the analysis of
 * all answers (at the higher levels of confidence, some participants have too few answers in any
 * study).
 */
public final class UntestableEffectReporter {
  private UntestableEffectReporter() {}

  /** Reports what a study cannot analyse, at the location of the area's first answer. */
  public static void tell(StudyAnalysis study, ProblemCollector problems) {
    if (study.conditions().size() == 1) {
      problems.warning(
          study.responses().usable().get(0).location(),
          "there is one condition only, %s; no effect of condition is tested"
              .formatted(study.conditions().get(0)));
    }
    for (String area : study.areas()) {
      SourceLocation place =
          study.responses().usable().stream()
              .filter(response -> response.area().equals(area))
              .map(Response::location)
              .findFirst()
              .orElseThrow();
      Map<String, Set<String>> measures = new LinkedHashMap<>();
      study
          .analyses(area)
          .filter(analysis -> analysis.level() == ConfidenceThreshold.ALL)
          .forEach(
              analysis ->
                  reasons(analysis)
                      .forEach(
                          reason ->
                              measures
                                  .computeIfAbsent(reason, first -> new LinkedHashSet<>())
                                  .add(analysis.measure().symbol())));
      measures.forEach(
          (reason, of) ->
              problems.warning(
                  place,
                  "%s of the area %s cannot be tested: %s"
                      .formatted(String.join(", ", of), area, reason)));
    }
  }

  private static List<String> reasons(AreaAnalysis analysis) {
    return analysis
        .anova()
        .map(UntestableEffectReporter::reasons)
        .orElseGet(() -> analysis.design().obstacle().map(List::of).orElse(List.of()));
  }

  /** Returns why effects of an analysis have no F, each reason once. */
  public static List<String> reasons(Anova anova) {
    return anova.effects().stream()
        .filter(effect -> !Double.isFinite(effect.f()))
        .map(Effect::flaw)
        .flatMap(Optional::stream)
        .distinct()
        .toList();
  }
}
