package org.selectiverenderer.chart;

/** What a page is drawn on: pixels from the upper left corner, y down. */
interface Canvas {
  void rectangle(double x, double y, double width, double height, ChartColour colour);

  /**
   * A line of text.
   *
   * @param x of its left end
   * @param y of its base line
   */
  void text(String text, double x, double y, SizedFont lettering, ChartColour colour);
}
