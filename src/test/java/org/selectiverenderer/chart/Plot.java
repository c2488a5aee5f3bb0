package org.selectiverenderer.chart;

/** A drawing of figures for a page of documentation. */
public sealed interface Plot permits BarPlot, LinePlot {
  /** An SVG file of 880 pixels' width, the same text every time. */
  String svg();
}
