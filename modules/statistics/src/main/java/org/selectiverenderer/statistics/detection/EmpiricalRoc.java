package org.selectiverenderer.statistics.detection;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The empirical receiver operating characteristic (ROC) of ratings, without a model: how the hit
 * rate grows with the false-alarm rate as the criterion becomes laxer.
 *
 * @param points points from (0, 0) to (1, 1), one for each criterion between used categories
 * @param area area under the straight lines between the points (AUC): the probability that a
 *     present object is rated higher than an absent one, with ties counted half (Bamber 1975,
 *     Journal of Mathematical Psychology 12)
 * @param standardError standard error of the area (DeLong, DeLong and Clarke-Pearson 1988,
 *     Biometrics 44); NaN with only one present or one absent object
 * @param flaw why there is no area, as a sentence without its full stop
 */
public record EmpiricalRoc(
    List<Point> points, double area, double standardError, Optional<String> flaw) {
  /** A point of the ROC. */
  public record Point(double falseAlarmRate, double hitRate) {}

  /** Makes defensive copies, so that the record is immutable. */
  public EmpiricalRoc {
    points = List.copyOf(points);
  }

  /** Returns the ROC of ratings. */
  public static EmpiricalRoc of(RatingCounts ratings) {
    RatingCounts used = ratings.used();
    int noise = used.noiseTotal();
    int signal = used.signalTotal();
    if (noise == 0 || signal == 0) {
      String lacking = noise > 0 ? "present" : signal > 0 ? "absent" : "present and absent";
      return new EmpiricalRoc(
          List.of(),
          Double.NaN,
          Double.NaN,
          Optional.of("no rating of %s objects".formatted(lacking)));
    }
    List<Point> points = new ArrayList<>(List.of(new Point(0, 0)));
    int falseAlarms = 0;
    int hits = 0;
    for (int i = used.categories() - 1; i >= 0; i--) {
      falseAlarms += used.noise().get(i);
      hits += used.signal().get(i);
      points.add(new Point((double) falseAlarms / noise, (double) hits / signal));
    }
    double area = 0;
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      area += (to.falseAlarmRate() - from.falseAlarmRate()) * (to.hitRate() + from.hitRate()) / 2;
    }
    double error =
        Math.sqrt(
            variance(used.signal(), used.noise(), area, false)
                + variance(used.noise(), used.signal(), area, true));
    return new EmpiricalRoc(points, area, error, Optional.empty());
  }

  /**
   * Returns the component of the area's variance that is due to the present, or to the absent,
   * objects: the variance of their placements. The placement of an object is the share of objects
   * of the other kind that it is rated on the correct side of.
   *
   * @param below whether the correct side is below the objects of the other kind
   */
  private static double variance(
      List<Integer> own, List<Integer> other, double area, boolean below) {
    double others = other.stream().mapToInt(Integer::intValue).sum();
    double n = own.stream().mapToInt(Integer::intValue).sum();
    double squares = 0;
    double lower = 0;
    for (int i = 0; i < own.size(); i++) {
      double placement = (lower + other.get(i) / 2.0) / others;
      double right = below ? 1 - placement : placement;
      squares += own.get(i) * (right - area) * (right - area);
      lower += other.get(i);
    }
    return n > 1 ? squares / (n - 1) / n : Double.NaN;
  }
}
