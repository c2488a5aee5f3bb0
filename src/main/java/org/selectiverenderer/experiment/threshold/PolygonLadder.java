package org.selectiverenderer.experiment.threshold;

import java.util.List;
import java.util.stream.IntStream;

/**
 * The versions of an object by their polygons, from the fewest to the original, which is the last.
 *
 * @param polygons each more than the one before; at least three
 */
public record PolygonLadder(List<Integer> polygons) {
  /**
   * @throws IllegalArgumentException if there are fewer than three, or one is no more than the one
   *     before
   */
  public PolygonLadder {
    polygons = List.copyOf(polygons);
    List<Integer> all = polygons;
    if (all.size() < 3
        || IntStream.range(1, all.size()).anyMatch(i -> all.get(i) <= all.get(i - 1))) {
      throw new IllegalArgumentException("no ladder: " + all);
    }
  }

  /**
   * Shares of an original for its reduced versions, each the same factor above the one before, the
   * last the same factor below the whole: polygons matter by their ratio.
   *
   * @param fewest share of the first, above 0 and below 1
   * @param rungs how many reduced versions, at least 2
   */
  public static double[] shares(double fewest, int rungs) {
    return IntStream.range(0, rungs)
        .mapToDouble(rung -> Math.pow(fewest, 1 - (double) rung / rungs))
        .toArray();
  }

  /** The last rung, the original. */
  public int original() {
    return polygons.size() - 1;
  }

  /** The polygons of the original. */
  public int all() {
    return polygons.get(original());
  }

  /** The polygons of a rung. */
  public int at(int rung) {
    return polygons.get(rung);
  }
}
