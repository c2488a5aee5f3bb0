package org.selectiverenderer.statistics.detection;

import java.util.Collection;

/** Counts of the four outcomes of signal detection (thesis Fig 91). */
public record ResponseCounts(int hits, int misses, int falseAlarms, int correctRejections) {
  /** Counts the outcomes of answers at a confidence level. */
  public static ResponseCounts of(
      Collection<Response> responses, ConfidenceThreshold level, LowConfidencePolicy guessing) {
    int[][] counts = new int[2][2];
    for (Response response : responses) {
      boolean admitted = level.admits(response);
      if (admitted || guessing == LowConfidencePolicy.AS_NO && response.confidence() > 0) {
        counts[response.present() ? 1 : 0][admitted && response.yes() ? 1 : 0]++;
      }
    }
    return new ResponseCounts(counts[1][1], counts[1][0], counts[0][1], counts[0][0]);
  }

  /** Returns the number of answers to objects that were present. */
  public int signals() {
    return hits + misses;
  }

  /** Returns the number of answers to objects that were absent. */
  public int noise() {
    return falseAlarms + correctRejections;
  }
}
