package org.selectiverenderer.chart;

import java.util.List;

/**
 * A chart of horizontal bars, which leave room for labels of any length.
 *
 * @param subtitle says what the bars' length is
 * @param unit after the numbers on the axis, for example {@code " %"}
 * @param least what the axis reaches at least
 * @param bars from top to bottom
 */
public record BarChart(String title, String subtitle, String unit, double least, List<Bar> bars) {
  /**
   * @param label on the left
   * @param value its length, at least 0
   * @param figure behind the bar
   */
  public record Bar(String label, double value, String figure, ChartColour colour) {}

  /** Keeps copies, so that it stays as it is. */
  public BarChart {
    bars = List.copyOf(bars);
  }

  /** What the axis reaches: the largest value, and something above 0. */
  double reach() {
    double largest = bars.stream().mapToDouble(Bar::value).max().orElse(0);
    return Math.max(Math.max(largest, least), 1e-9);
  }
}
