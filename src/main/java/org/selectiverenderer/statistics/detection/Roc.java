package org.selectiverenderer.statistics.detection;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The receiver operating characteristic of ratings, without a model: how the hit rate grows with
 * the false alarm rate as the criterion becomes laxer.
 *
 * @param points from 0, 0 to 1, 1, one for each criterion between used categories
 * @param area under the straight lines between the points: the probability that a present object is
 *     rated higher than an absent one, ties counted half (Bamber 1975, Journal of Mathematical
 *     Psychology 12)
 * @param standardError of the area (DeLong, DeLong and Clarke-Pearson 1988, Biometrics 44); not a
 *     number with one object of a kind
 * @param flaw why there is no area: a sentence without its full stop
 */
public record Roc(List<Point> points, double area, double standardError, Optional<String> flaw) {
  /** A pair of rates. */
  public record Point(double falseAlarmRate, double hitRate) {}

  /** Keeps copies, so that it stays as it is. */
  public Roc {
    points = List.copyOf(points);
  }

  /** Of ratings. */
  public static Roc of(RatingCounts ratings) {
    RatingCounts used = ratings.used();
    int noise = used.noiseTotal();
    int signal = used.signalTotal();
    if (noise == 0 || signal == 0) {
      String lacking = noise > 0 ? "present" : signal > 0 ? "absent" : "present and absent";
      return new Roc(
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
    return new Roc(points, area, error, Optional.empty());
  }

  /**
   * The share of the area's variance that comes from the objects of one kind: each object's
   * placement is the share of the other kind that it is rated on the right side of.
   *
   * @param below whether the right side is below the other kind
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
