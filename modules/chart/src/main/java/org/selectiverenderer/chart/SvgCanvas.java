package org.selectiverenderer.chart;

import java.util.List;
import org.selectiverenderer.formats.image.SvgPrecision;
import org.selectiverenderer.formats.image.SvgWriter;

/**
 * Draws to SVG. Text is written as text elements with their length, so that nothing overlaps in a
 * viewer that lacks the font.
 */
public final class SvgCanvas implements ChartCanvas {
  private final String prologue;
  private final SvgWriter svg;

  /** Creates a canvas for a complete SVG file. */
  public SvgCanvas(int width, int height, String title) {
    this(width, height, title, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  }

  private SvgCanvas(int width, int height, String title, String prologue) {
    this.prologue = prologue;
    String fonts = "'DejaVu Sans', Verdana, sans-serif";
    svg = new SvgWriter(width, height, fonts, title, SvgPrecision.HUNDREDTHS);
  }

  /** Creates a canvas for an SVG element within an HTML page. */
  public static SvgCanvas inline(int width, int height, String title) {
    return new SvgCanvas(width, height, title, "");
  }

  /** Draws a straight line. */
  public void line(double x1, double y1, double x2, double y2, double width, ChartColour colour) {
    String data = svg.line(List.of(new double[] {x1, y1}, new double[] {x2, y2}));
    svg.path(data, "stroke", colour.hex(), "stroke-width", width);
  }

  /**
   * Draws round dots of one colour.
   *
   * @param points x and y of each dot
   * @param opacity from 0 to 1
   */
  public void dots(List<double[]> points, double radius, ChartColour colour, double opacity) {
    StringBuilder data = new StringBuilder();
    points.forEach(point -> data.append(svg.line(List.of(point))).append("h0"));
    svg.path(
        data.toString(),
        "stroke",
        colour.hex(),
        "stroke-width",
        2 * radius,
        "stroke-linecap",
        "round",
        "stroke-opacity",
        opacity);
  }

  @Override
  public void rectangle(double x, double y, double width, double height, ChartColour colour) {
    svg.rectangle(x, y, width, height, colour.hex());
  }

  @Override
  public void text(String text, double x, double y, SizedFont lettering, ChartColour colour) {
    if (text.isBlank()) {
      return;
    }
    svg.text(
        text,
        x,
        y,
        "font-size",
        lettering.size(),
        "font-weight",
        lettering.bold() ? "bold" : "",
        "fill",
        colour.hex(),
        "textLength",
        lettering.width(text),
        "lengthAdjust",
        "spacingAndGlyphs");
  }

  /** Returns the SVG text; nothing may be drawn afterwards. */
  public String finish() {
    return prologue + svg.finish();
  }
}
