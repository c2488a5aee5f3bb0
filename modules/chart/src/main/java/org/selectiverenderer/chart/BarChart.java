package org.selectiverenderer.chart;

import java.util.List;

/**
 * A bar chart with horizontal bars, which leave room for labels of any length.
 *
 * @param subtitle says what the length of the bars stands for
 * @param unit suffix of the numbers on the axis, for example {@code " %"}
 * @param least a value that the axis includes at least
 * @param bars from top to bottom
 */
public record BarChart(String title, String subtitle, String unit, double least, List<Bar> bars) {
  /**
   * @param label label on the left
   * @param value its length, at least 0
   * @param figure text at the end of the bar
   */
  public record Bar(String label, double value, String figure, ChartColour colour) {}

  /** Makes defensive copies, so that the record is immutable. */
  public BarChart {
    bars = List.copyOf(bars);
  }

  /** Returns the largest value on the axis: that of the bars and of {@code least}, and above 0. */
  double reach() {
    double largest = bars.stream().mapToDouble(Bar::value).max().orElse(0);
    return Math.max(Math.max(largest, least), 1e-9);
  }
}
