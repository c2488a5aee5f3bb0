package org.selectiverenderer.control.budget;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The versions among which the budget chooses for one object.
 *
 * @param costs the triangles of each version, at least 0
 * @param losses what each version loses in quality, for an object of weight 1: finite, at least 0
 */
public record VersionChoices(List<Long> costs, List<Double> losses) {
  /** Checks the numbers. */
  public VersionChoices {
    costs = List.copyOf(costs);
    losses = List.copyOf(losses);
    if (costs.isEmpty() || costs.size() != losses.size()) {
      throw new IllegalArgumentException(
          costs.size() + " costs and " + losses.size() + " losses; each version needs both");
    }
    if (costs.stream().anyMatch(cost -> cost < 0)
        || losses.stream().anyMatch(loss -> !(loss >= 0 && loss < Double.POSITIVE_INFINITY))) {
      throw new IllegalArgumentException("costs and losses must be finite and at least 0");
    }
  }

  /**
   * Returns the versions on the lower convex hull of loss over cost, the cheapest first: costs
   * rise, losses fall, and each step saves at most as much loss per triangle as the one before. A
   * version off the hull is dearer than another that loses no more, or than a mix of two; no
   * solution of the relaxed problem has it (Sinha and Zoltners 1979).
   */
  int[] hull() {
    List<Integer> byCost =
        IntStream.range(0, costs.size())
            .boxed()
            .sorted(
                Comparator.comparingLong((Integer i) -> costs.get(i))
                    .thenComparingDouble(losses::get))
            .toList();
    List<Integer> hull = new ArrayList<>();
    for (int next : byCost) {
      if (!hull.isEmpty() && losses.get(next) >= losses.get(last(hull))) {
        continue; // Dearer, and no better.
      }
      while (hull.size() > 1
          && saved(hull.get(hull.size() - 2), last(hull)) < saved(last(hull), next)) {
        hull.remove(hull.size() - 1);
      }
      hull.add(next);
    }
    return hull.stream().mapToInt(Integer::intValue).toArray();
  }

  private static int last(List<Integer> hull) {
    return hull.get(hull.size() - 1);
  }

  /** Returns the loss that a dearer version saves for each triangle that it has more. */
  double saved(int from, int to) {
    return (losses.get(from) - losses.get(to)) / (costs.get(to) - costs.get(from));
  }
}
