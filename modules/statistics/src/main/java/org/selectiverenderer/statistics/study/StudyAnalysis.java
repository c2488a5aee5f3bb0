package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScore;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.Response;

/**
 * The scores and analyses of a study.
 *
 * @param conditions the conditions in the order of tables: those of the thesis first, others in the
 *     order of the file
 * @param areas the areas in the order of the file
 * @param scores the scores of each participant
 * @param analyses the analyses, area by area, level by level, measure by measure
 * @param family the correction for multiple testing
 * @param tests every effect of the analyses, with its corrected p
 * @param ratings analyses of ratings, pooled and of each participant
 */
public record StudyAnalysis(
    Responses responses,
    DetectionScorer scoring,
    AnovaOptions options,
    List<String> conditions,
    List<String> areas,
    List<DetectionScore> scores,
    List<AreaAnalysis> analyses,
    MultipleTestingCorrection family,
    List<FamilywiseTest> tests,
    List<RatingAnalysis> ratings) {
  private static final List<String> THESIS_ORDER =
      List.of("high", "high-low", "selective", "random");

  /** Makes defensive copies, so that the record is immutable. */
  public StudyAnalysis {
    conditions = List.copyOf(conditions);
    areas = List.copyOf(areas);
    scores = List.copyOf(scores);
    analyses = List.copyOf(analyses);
    tests = List.copyOf(tests);
    ratings = List.copyOf(ratings);
  }

  /** Scores and analyses answers without a correction for multiple testing. */
  public static StudyAnalysis of(
      Responses responses, DetectionScorer scoring, AnovaOptions options) {
    return of(responses, scoring, options, MultipleTestingCorrection.NONE);
  }

  /** Scores and analyses answers. */
  public static StudyAnalysis of(
      Responses responses,
      DetectionScorer scoring,
      AnovaOptions options,
      MultipleTestingCorrection family) {
    List<Response> usable = responses.usable();
    List<DetectionScore> scores = scoring.scores(usable);
    List<String> conditions = conditions(usable);
    List<String> areas = usable.stream().map(Response::area).distinct().toList();
    List<AreaAnalysis> analyses = new ArrayList<>();
    for (String area : areas) {
      AreaAnalyser own =
          new AreaAnalyser(
              area,
              conditions,
              scores.stream().filter(score -> score.area().equals(area)).toList());
      for (ConfidenceThreshold level : ConfidenceThreshold.values()) {
        for (DetectionMeasure measure : DetectionMeasure.values()) {
          analyses.add(own.analysis(level, measure, options));
        }
      }
    }
    return new StudyAnalysis(
        responses,
        scoring,
        options,
        conditions,
        areas,
        scores,
        analyses,
        family,
        FamilywiseTest.of(analyses, family),
        RatingAnalysis.of(usable, conditions, areas));
  }

  /** Returns the conditions in the order of tables. */
  static List<String> conditions(List<Response> responses) {
    return responses.stream()
        .map(Response::condition)
        .distinct()
        .sorted(Comparator.comparingInt(StudyAnalysis::rank))
        .toList();
  }

  private static int rank(String condition) {
    int index = THESIS_ORDER.indexOf(condition);
    return index < 0 ? THESIS_ORDER.size() : index;
  }

  /** Returns all participants with answers. */
  public List<String> participants() {
    return scores.stream().map(DetectionScore::participant).distinct().toList();
  }

  /** Returns the number of participants of a condition with answers. */
  public long participants(String condition) {
    return scores.stream()
        .filter(score -> score.condition().equals(condition))
        .map(DetectionScore::participant)
        .distinct()
        .count();
  }

  /** Returns the analyses of an area. */
  public Stream<AreaAnalysis> analyses(String area) {
    return analyses.stream().filter(analysis -> analysis.area().equals(area));
  }

  /**
   * Returns p of an effect after the correction for multiple testing; NaN if the effect has no p.
   */
  public double adjusted(AreaAnalysis analysis, Effect effect) {
    return tests.stream()
        .filter(test -> test.analysis() == analysis && test.effect() == effect)
        .mapToDouble(FamilywiseTest::adjusted)
        .findFirst()
        .orElse(Double.NaN);
  }

  /** Returns the analyses of ratings of an area, of each condition or of each participant. */
  public List<RatingAnalysis> ratings(String area, boolean pooled) {
    return ratings.stream()
        .filter(score -> score.area().equals(area) && score.participant().isEmpty() == pooled)
        .toList();
  }

  /** Returns how many answers have no confidence and are therefore not ratings. */
  public long unrated() {
    return responses.usable().stream().filter(response -> response.confidence() == 0).count();
  }
}
