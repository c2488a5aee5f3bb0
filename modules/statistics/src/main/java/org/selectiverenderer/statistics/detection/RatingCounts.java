package org.selectiverenderer.statistics.detection;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;

/**
 * Counts of answers as confidence ratings, from "surely no" (confidence 5) over "no" and "yes"
 * without confidence to "surely yes": the rating design (Macmillan and Creelman 2005, chapter 3).
 *
 * @param noise number of answers to absent objects in each category
 * @param signal number of answers to present objects in each category
 */
public record RatingCounts(List<Integer> noise, List<Integer> signal) {
  /** The number of categories: two answers with five confidences each. */
  public static final int CATEGORIES = 2 * Response.MOST_CONFIDENCE;

  /** Checks that noise and signal have the same number of categories. */
  public RatingCounts {
    noise = List.copyOf(noise);
    signal = List.copyOf(signal);
    if (noise.size() != signal.size()) {
      throw new IllegalArgumentException("noise and signal differ in their categories");
    }
  }

  /** Counts answers; those without a confidence are ignored. */
  public static RatingCounts of(Collection<Response> responses) {
    Integer[] noise = zeros();
    Integer[] signal = zeros();
    for (Response response : responses) {
      if (response.confidence() > 0) {
        (response.present() ? signal : noise)[category(response)]++;
      }
    }
    return new RatingCounts(List.of(noise), List.of(signal));
  }

  private static Integer[] zeros() {
    Integer[] counts = new Integer[CATEGORIES];
    Arrays.fill(counts, 0);
    return counts;
  }

  /** Returns the category: 0 for "no" with confidence 5 to 9 for "yes" with confidence 5. */
  private static int category(Response response) {
    int confidence = response.confidence();
    return response.yes()
        ? Response.MOST_CONFIDENCE - 1 + confidence
        : Response.MOST_CONFIDENCE - confidence;
  }

  /**
   * Returns the counts without categories that were never used, between which no criterion can be
   * estimated.
   */
  RatingCounts used() {
    List<Integer> usedNoise = new ArrayList<>();
    List<Integer> usedSignal = new ArrayList<>();
    for (int i = 0; i < noise.size(); i++) {
      if (noise.get(i) + signal.get(i) > 0) {
        usedNoise.add(noise.get(i));
        usedSignal.add(signal.get(i));
      }
    }
    return new RatingCounts(usedNoise, usedSignal);
  }

  /** Returns the number of categories. */
  int categories() {
    return noise.size();
  }

  /** Returns the number of ratings of absent objects. */
  public int noiseTotal() {
    return noise.stream().mapToInt(Integer::intValue).sum();
  }

  /** Returns the number of ratings of present objects. */
  public int signalTotal() {
    return signal.stream().mapToInt(Integer::intValue).sum();
  }
}
