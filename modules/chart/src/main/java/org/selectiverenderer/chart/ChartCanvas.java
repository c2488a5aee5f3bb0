package org.selectiverenderer.chart;

/** A surface to draw on. Coordinates are in pixels from the upper left corner, with y down. */
interface ChartCanvas {
  void rectangle(double x, double y, double width, double height, ChartColour colour);

  /**
   * Draws a line of text.
   *
   * @param x x of its left end
   * @param y y of its baseline
   */
  void text(String text, double x, double y, SizedFont lettering, ChartColour colour);
}
