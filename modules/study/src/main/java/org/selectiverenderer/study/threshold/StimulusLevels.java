package org.selectiverenderer.study.threshold;

import java.util.List;
import java.util.stream.IntStream;

/**
 * The stimulus levels of an object: its versions by number of polygons, from the fewest to the
 * original, which is the last rung.
 *
 * @param polygons numbers of polygons in ascending order, at least three
 */
public record StimulusLevels(List<Integer> polygons) {
  /**
   * @throws IllegalArgumentException if there are fewer than three, or they are not in ascending
   *     order
   */
  public StimulusLevels {
    polygons = List.copyOf(polygons);
    List<Integer> all = polygons;
    if (all.size() < 3
        || IntStream.range(1, all.size()).anyMatch(i -> all.get(i) <= all.get(i - 1))) {
      throw new IllegalArgumentException("no ladder: " + all);
    }
  }

  /**
   * Returns the shares of the original's polygons for the reduced versions, in a geometric sequence
   * that ends one factor below 1, as the effect of polygons depends on their ratio.
   *
   * @param fewest share of the first version, above 0 and below 1
   * @param rungs number of reduced versions, at least 2
   */
  public static double[] shares(double fewest, int rungs) {
    return IntStream.range(0, rungs)
        .mapToDouble(rung -> Math.pow(fewest, 1 - (double) rung / rungs))
        .toArray();
  }

  /** Returns the last rung, that of the original. */
  public int original() {
    return polygons.size() - 1;
  }

  /** Returns the number of polygons of the original. */
  public int all() {
    return polygons.get(original());
  }

  /** Returns the number of polygons of a rung. */
  public int at(int rung) {
    return polygons.get(rung);
  }
}
