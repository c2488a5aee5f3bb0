package org.selectiverenderer.chart;

import java.util.function.DoubleFunction;

/**
 * The axis of horizontal bars.
 *
 * @param reach the largest value on it, above 0
 * @param left where 0 is, in pixels
 * @param scale pixels per 1
 */
record BarAxis(double reach, double left, double scale) {
  /**
   * Draws a line for each mark, and its number where there is room for it.
   *
   * @param top of the lines
   * @param bottom of the bars; the numbers are below
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
