package org.selectiverenderer.chart;

import java.util.function.DoubleFunction;

/**
 * The value axis of a chart with horizontal bars.
 *
 * @param reach the largest value on it, above 0
 * @param left x of the value 0, in pixels
 * @param scale pixels per unit of value
 */
record BarAxis(double reach, double left, double scale) {
  /**
   * Draws a grid line for each tick, and its number where there is room for it.
   *
   * @param top y of the upper ends of the grid lines
   * @param bottom y of the lower end of the bars; the numbers are below
   */
  void draw(
      Canvas canvas, double top, double bottom, SizedFont small, DoubleFunction<String> number) {
    double step = AxisStep.of(reach);
    double free = Double.NEGATIVE_INFINITY; // right of the last number
    for (int i = 0; i * step <= reach * (1 + 1e-9); i++) {
      double x = Math.rint(left + i * step * scale);
      canvas.rectangle(x, top, 1, bottom - top + 5, ChartColour.GRID);
      String text = number.apply(i * step);
      double half = small.width(text) / 2;
      if (x - half > free) {
        canvas.text(text, x - half, bottom + 22, small, ChartColour.FAINT_INK);
        free = x + half + 12;
      }
    }
  }
}
