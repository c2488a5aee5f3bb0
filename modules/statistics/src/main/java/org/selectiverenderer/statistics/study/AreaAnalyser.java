package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.SignificanceTests;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.Response;

/** Analyses the scores of one area. */
public final class AreaAnalyser {
  /** The between factor's name. */
  public static final String BETWEEN = "condition";

  /** The within factor's name. */
  public static final String WITHIN = "object type";

  private final String area;
  private final List<String> conditions;
  private final List<String> types;
  private final List<DetectionScore> scores;

  AreaAnalyser(String area, List<String> conditions, List<DetectionScore> scores) {
    this.area = area;
    this.conditions = conditions;
    this.scores = scores;
    types =
        Response.TYPES.stream()
            .filter(type -> scores.stream().anyMatch(score -> score.type().equals(type)))
            .toList();
  }

  /** Scores the answers about an area. */
  public static AreaAnalyser of(Responses responses, DetectionScorer scoring, String area) {
    return of(responses, scoring, area, List.of(ConfidenceThreshold.values()));
  }

  /** Scores the answers about an area at some levels of confidence. */
  public static AreaAnalyser of(
      Responses responses, DetectionScorer scoring, String area, List<ConfidenceThreshold> levels) {
    return new AreaAnalyser(
        area,
        StudyAnalysis.conditions(responses.usable()),
        scoring.scores(responses.usable(), levels).stream()
            .filter(score -> score.area().equals(area))
            .toList());
  }

  /** Analyses one measure at one level of confidence. */
  public AreaAnalysis analysis(
      ConfidenceThreshold level, DetectionMeasure measure, AnovaOptions options) {
    List<String> notes = new ArrayList<>();
    Map<String, List<Subject>> groups = complete(level, measure, notes);
    FactorialDesign design = design(measure, groups, notes);
    Optional<String> obstacle = design.obstacle();
    obstacle.ifPresent(reason -> notes.add("Not analysed: " + reason + "."));
    Optional<Anova> anova =
        obstacle.isPresent() ? Optional.empty() : Optional.of(Anova.of(design, options));
    return new AreaAnalysis(area, level, measure, design, anova, notes);
  }

  /** Returns the significance tests of that analysis only; empty where it has none. */
  public Optional<SignificanceTests> tests(
      ConfidenceThreshold level, DetectionMeasure measure, AnovaOptions options) {
    List<String> notes = new ArrayList<>();
    FactorialDesign design = design(measure, complete(level, measure, notes), notes);
    return design.obstacle().isPresent()
        ? Optional.empty()
        : Optional.of(SignificanceTests.of(design, options));
  }

  /** Returns the participants with a score for every type, by condition, and notes the others. */
  private Map<String, List<Subject>> complete(
      ConfidenceThreshold level, DetectionMeasure measure, List<String> notes) {
    Map<String, Map<String, DetectionScore>> participants = new LinkedHashMap<>();
    for (DetectionScore score : scores) {
      if (score.level() == level) {
        participants
            .computeIfAbsent(score.participant(), id -> new LinkedHashMap<>())
            .put(score.type(), score);
      }
    }
    Map<String, List<Subject>> groups = new LinkedHashMap<>();
    Map<String, List<String>> left = new LinkedHashMap<>();
    participants.forEach(
        (id, own) -> {
          List<String> flaws = flaws(own, measure);
          String condition = own.values().iterator().next().condition();
          if (flaws.isEmpty()) {
            groups
                .computeIfAbsent(condition, name -> new ArrayList<>())
                .add(new Subject(id, conditions.indexOf(condition), values(own, measure)));
          } else {
            left.computeIfAbsent(String.join("; ", flaws), why -> new ArrayList<>()).add(id);
          }
        });
    left.forEach(
        (why, ids) ->
            notes.add(
                "Left out because %s: %s (%d)."
                    .formatted(why, String.join(", ", ids), ids.size())));
    return groups;
  }

  /** Returns the design of the conditions that have participants, and notes the others. */
  private FactorialDesign design(
      DetectionMeasure measure, Map<String, List<Subject>> groups, List<String> notes) {
    List<String> filled = conditions.stream().filter(groups::containsKey).toList();
    conditions.stream()
        .filter(condition -> !filled.contains(condition))
        .forEach(name -> notes.add("The condition " + name + " has no complete participant."));
    if (filled.size() == 1) {
      notes.add("There is one condition only, " + filled.get(0) + ": no effect of condition.");
    }
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < filled.size(); group++) {
      for (Subject subject : groups.get(filled.get(group))) {
        subjects.add(new Subject(subject.id(), group, subject.values()));
      }
    }
    return new FactorialDesign(
        measure.key(),
        new Factor(WITHIN, types),
        new Factor(BETWEEN, filled.isEmpty() ? conditions : filled),
        subjects);
  }

  private List<String> flaws(Map<String, DetectionScore> own, DetectionMeasure measure) {
    List<String> flaws = new ArrayList<>();
    for (String type : types) {
      DetectionScore score = own.get(type);
      if (score == null) {
        flaws.add("there is no answer to " + type + " objects");
      } else if (!Double.isFinite(measure.of(score.detection()))) {
        flaws.add(score.detection().flaw().orElse("not defined") + " (" + type + " objects)");
      }
    }
    return flaws;
  }

  private List<Double> values(Map<String, DetectionScore> own, DetectionMeasure measure) {
    return types.stream()
        .map(type -> measure.of(Objects.requireNonNull(own.get(type)).detection()))
        .toList();
  }
}
