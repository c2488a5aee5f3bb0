package org.selectiverenderer.app.chart;

import java.util.List;
import org.selectiverenderer.chart.Colour;

/**
 * A chart of horizontal bars, which leave room for labels of any length.
 *
 * @param subtitle says what the bars' length is
 * @param unit after the numbers on the axis, for example {@code " %"}
 * @param least what the axis reaches at least
 * @param bars from top to bottom
 */
record Chart(String title, String subtitle, String unit, double least, List<Bar> bars) {
  /**
   * @param label on the left
   * @param value its length, at least 0
   * @param figure behind the bar
   */
  record Bar(String label, double value, String figure, Colour colour) {}

  Chart {
    bars = List.copyOf(bars);
  }

  /** What the axis reaches: the largest value, and something above 0. */
  double reach() {
    double largest = bars.stream().mapToDouble(Bar::value).max().orElse(0);
    return Math.max(Math.max(largest, least), 1e-9);
  }

  /** The distance of marks on the axis: 1, 2 or 5 times a power of ten, four to ten in all. */
  double step() {
    double power = Math.pow(10, Math.floor(Math.log10(reach() / 4)));
    double ratio = reach() / 4 / power;
    return power * (ratio >= 5 ? 5 : ratio >= 2 ? 2 : 1);
  }
}
