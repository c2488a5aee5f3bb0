package org.selectiverenderer.statistics.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.statistics.detection.EmpiricalRoc;
import org.selectiverenderer.statistics.detection.RatingCounts;
import org.selectiverenderer.statistics.detection.Response;
import org.selectiverenderer.statistics.detection.UnequalVarianceFit;

/**
 * The analysis of the confidence ratings of one object type in one area, of one participant or
 * pooled over a condition.
 *
 * <p>Pooled ratings treat the answers of many participants as those of one. Criteria that differ
 * between participants flatten the pooled ROC, so its d_a is below the mean of the participants'
 * d_a, and standard errors ignore that answers of one participant are correlated (Macmillan and
 * Creelman 2005, chapter 13). They show the shape of the ROC; conditions are compared by the
 * participants' scores only.
 *
 * @param participant empty for the ratings of all of the condition
 * @param participants number of participants whose ratings these are
 */
public record RatingAnalysis(
    String area,
    String condition,
    Optional<String> participant,
    String type,
    int participants,
    RatingCounts ratings,
    EmpiricalRoc roc,
    UnequalVarianceFit fit) {
  private record Key(String area, String condition, Optional<String> participant, String type) {}

  /**
   * Returns the pooled analysis of each condition, then that of each participant; areas and
   * participants are in the order of the file.
   */
  static List<RatingAnalysis> of(
      List<Response> responses, List<String> conditions, List<String> areas) {
    Map<Key, List<Response>> pooled = new LinkedHashMap<>();
    for (String area : areas) {
      for (String type : Response.TYPES) {
        conditions.forEach(
            name -> pooled.put(new Key(area, name, Optional.empty(), type), new ArrayList<>()));
      }
    }
    Map<Key, List<Response>> own = new LinkedHashMap<>();
    for (Response response : responses) {
      Key key = new Key(response.area(), response.condition(), Optional.empty(), response.type());
      pooled.computeIfAbsent(key, first -> new ArrayList<>()).add(response);
      own.computeIfAbsent(
              new Key(key.area(), key.condition(), Optional.of(response.participant()), key.type()),
              first -> new ArrayList<>())
          .add(response);
    }
    List<RatingAnalysis> scores = new ArrayList<>();
    pooled.forEach((key, answers) -> add(key, answers, scores));
    own.forEach((key, answers) -> add(key, answers, scores));
    return scores;
  }

  private static void add(Key key, List<Response> answers, List<RatingAnalysis> scores) {
    if (answers.isEmpty()) {
      return;
    }
    RatingCounts ratings = RatingCounts.of(answers);
    scores.add(
        new RatingAnalysis(
            key.area(),
            key.condition(),
            key.participant(),
            key.type(),
            (int) answers.stream().map(Response::participant).distinct().count(),
            ratings,
            EmpiricalRoc.of(ratings),
            UnequalVarianceFit.of(ratings)));
  }
}
