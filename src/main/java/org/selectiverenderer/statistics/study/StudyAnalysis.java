package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceLevel;
import org.selectiverenderer.statistics.detection.Measure;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.statistics.detection.Score;
import org.selectiverenderer.statistics.detection.Scoring;

/**
 * A study analysed.
 *
 * @param conditions in the order of tables: the thesis's first, others as in the file
 * @param areas as in the file
 * @param scores of each participant
 * @param analyses area by area, level by level, measure by measure
 * @param family what is done about their number
 * @param tests every effect of the analyses, with its p after that correction
 * @param ratings pooled and of each participant
 */
public record StudyAnalysis(
    Responses responses,
    Scoring scoring,
    AnovaOptions options,
    List<String> conditions,
    List<String> areas,
    List<Score> scores,
    List<AreaAnalysis> analyses,
    FamilyCorrection family,
    List<FamilyTest> tests,
    List<RatingScore> ratings) {
  private static final List<String> THESIS_ORDER =
      List.of("high", "high-low", "selective", "random");

  /** Keeps copies, so that it stays as it is. */
  public StudyAnalysis {
    conditions = List.copyOf(conditions);
    areas = List.copyOf(areas);
    scores = List.copyOf(scores);
    analyses = List.copyOf(analyses);
    tests = List.copyOf(tests);
    ratings = List.copyOf(ratings);
  }

  /** Scores and analyses of answers, each test for itself. */
  public static StudyAnalysis of(Responses responses, Scoring scoring, AnovaOptions options) {
    return of(responses, scoring, options, FamilyCorrection.NONE);
  }

  /** Scores and analyses of answers. */
  public static StudyAnalysis of(
      Responses responses, Scoring scoring, AnovaOptions options, FamilyCorrection family) {
    List<Response> usable = responses.usable();
    List<Score> scores = scoring.scores(usable);
    List<String> conditions = conditions(usable);
    List<String> areas = usable.stream().map(Response::area).distinct().toList();
    List<AreaAnalysis> analyses = new ArrayList<>();
    for (String area : areas) {
      AreaStudy own =
          new AreaStudy(
              area,
              conditions,
              scores.stream().filter(score -> score.area().equals(area)).toList());
      for (ConfidenceLevel level : ConfidenceLevel.values()) {
        for (Measure measure : Measure.values()) {
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
        FamilyTest.of(analyses, family),
        RatingScore.of(usable, conditions, areas));
  }

  /** Conditions in the order of tables. */
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

  /** Everyone who answered. */
  public List<String> participants() {
    return scores.stream().map(Score::participant).distinct().toList();
  }

  /** Everyone of a condition who answered. */
  public long participants(String condition) {
    return scores.stream()
        .filter(score -> score.condition().equals(condition))
        .map(Score::participant)
        .distinct()
        .count();
  }

  /** The analyses of an area. */
  public Stream<AreaAnalysis> analyses(String area) {
    return analyses.stream().filter(analysis -> analysis.area().equals(area));
  }

  /** The p of an effect after the correction of the study's tests; not a number without a p. */
  public double adjusted(AreaAnalysis analysis, Effect effect) {
    return tests.stream()
        .filter(test -> test.analysis() == analysis && test.effect() == effect)
        .mapToDouble(FamilyTest::adjusted)
        .findFirst()
        .orElse(Double.NaN);
  }

  /** Ratings of an area: of each condition, or of each participant. */
  public List<RatingScore> ratings(String area, boolean pooled) {
    return ratings.stream()
        .filter(score -> score.area().equals(area) && score.participant().isEmpty() == pooled)
        .toList();
  }

  /** How many answers have no confidence and so are no ratings. */
  public long unrated() {
    return responses.usable().stream().filter(response -> response.confidence() == 0).count();
  }
}
