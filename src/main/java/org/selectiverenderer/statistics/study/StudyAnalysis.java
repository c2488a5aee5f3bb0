package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.statistics.anova.AnovaOptions;
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
 */
public record StudyAnalysis(
    Responses responses,
    Scoring scoring,
    AnovaOptions options,
    List<String> conditions,
    List<String> areas,
    List<Score> scores,
    List<AreaAnalysis> analyses) {
  private static final List<String> THESIS_ORDER =
      List.of("high", "high-low", "selective", "random");

  public StudyAnalysis {
    conditions = List.copyOf(conditions);
    areas = List.copyOf(areas);
    scores = List.copyOf(scores);
    analyses = List.copyOf(analyses);
  }

  /** Scores and analyses of answers. */
  public static StudyAnalysis of(Responses responses, Scoring scoring, AnovaOptions options) {
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
    return new StudyAnalysis(responses, scoring, options, conditions, areas, scores, analyses);
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
}
