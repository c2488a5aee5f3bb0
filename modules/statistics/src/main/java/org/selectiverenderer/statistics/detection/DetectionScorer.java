package org.selectiverenderer.statistics.detection;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Computes signal detection scores from answers.
 *
 * @param correction correction of rates of 0 and 1
 * @param guessing how answers below a confidence level are scored
 */
public record DetectionScorer(ExtremeRateCorrection correction, LowConfidencePolicy guessing) {
  /**
   * The default: Hautus's log-linear correction; answers below the confidence level are left out.
   */
  public static final DetectionScorer DEFAULT =
      new DetectionScorer(ExtremeRateCorrection.LOG_LINEAR, LowConfidencePolicy.DISCARD);

  private record Key(String participant, String condition, String area, String type) {}

  /**
   * Returns a score for each participant, area, type and confidence level, in the order of the
   * answers.
   */
  public List<DetectionScore> scores(Collection<Response> responses) {
    return scores(responses, List.of(ConfidenceThreshold.values()));
  }

  /** Returns the scores of some confidence levels. */
  public List<DetectionScore> scores(
      Collection<Response> responses, List<ConfidenceThreshold> levels) {
    Map<Key, List<Response>> cells = new LinkedHashMap<>();
    for (Response response : responses) {
      cells
          .computeIfAbsent(
              new Key(
                  response.participant(), response.condition(), response.area(), response.type()),
              key -> new ArrayList<>())
          .add(response);
    }
    List<DetectionScore> scores = new ArrayList<>();
    cells.forEach(
        (key, cell) -> {
          for (ConfidenceThreshold level : levels) {
            ResponseCounts counts = ResponseCounts.of(cell, level, guessing);
            scores.add(
                new DetectionScore(
                    key.participant(),
                    key.condition(),
                    key.area(),
                    key.type(),
                    level,
                    cell.size(),
                    counts,
                    DetectionIndices.of(counts, correction)));
          }
        });
    return scores;
  }
}
