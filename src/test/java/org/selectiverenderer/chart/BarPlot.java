package org.selectiverenderer.chart;

import java.util.HashSet;
import java.util.List;
import java.util.Map;

/**
 * Horizontal bars of several series: those of a group one below the other, or one behind the other
 * as parts of a whole.
 *
 * @param subtitle says what the bars' length is
 * @param unit after the numbers on the axis, for example {@code " ms"}; may be empty
 * @param stacked whether a group is one bar, its series being the parts
 * @param series names for the legend, at most seven, each once
 * @param groups from top to bottom
 */
public record BarPlot(
    String title,
    String subtitle,
    String unit,
    boolean stacked,
    List<String> series,
    List<Group> groups)
    implements Plot {
  /**
   * @param label on the left
   * @param values of series, at least 0; one that was not measured is missing
   */
  public record Group(String label, Map<String, Double> values) {
    public Group {
      values = Map.copyOf(values);
    }

    double sum() {
      return values.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    double largest() {
      return values.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
    }
  }

  /**
   * @throws IllegalArgumentException if there are too many series, two of one name, or a value that
   *     is negative, not finite or of no series
   */
  public BarPlot {
    series = List.copyOf(series);
    groups = List.copyOf(groups);
    if (series.size() > SeriesPalette.limit()) {
      throw new IllegalArgumentException(series.size() + " series cannot be told apart");
    }
    if (new HashSet<>(series).size() < series.size()) {
      throw new IllegalArgumentException("two series have one name: " + series);
    }
    for (Group group : groups) {
      group.values().forEach(BarPlot::check);
      if (!series.containsAll(group.values().keySet())) {
        throw new IllegalArgumentException(
            group.label() + " has a value of no series: " + group.values().keySet());
      }
    }
  }

  private static void check(String name, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " has no length: " + value);
    }
  }

  @Override
  public String svg() {
    return new BarPlotRenderer(this).svg();
  }

  /** What the axis reaches: the longest bar, and something above 0. */
  double reach() {
    return Math.max(
        1e-9, groups.stream().mapToDouble(g -> stacked ? g.sum() : g.largest()).max().orElse(0));
  }
}
