package org.selectiverenderer.formats.image;

import java.util.List;
import org.selectiverenderer.base.markup.MarkupEscaper;

/**
 * Writes a drawing as SVG 1.1. A style is a sequence of alternating attribute names and values. A
 * {@code Double} is written with the drawing's precision, and an attribute with an empty value is
 * left out.
 */
public final class SvgWriter {
  private final StringBuilder svg = new StringBuilder();
  private final SvgPrecision precision;

  /**
   * Creates an empty drawing.
   *
   * @param fonts font families in order of preference
   * @param title the title that viewers show
   */
  public SvgWriter(int width, int height, String fonts, String title, SvgPrecision precision) {
    this.precision = precision;
    begin("svg", "xmlns", "http://www.w3.org/2000/svg", "width", width, "height", height);
    attributes("viewBox", "0 0 " + width + " " + height, "font-family", fonts);
    svg.append(">\n<title>").append(MarkupEscaper.text(title)).append("</title>\n");
  }

  /** Adds a rectangle; a negative width or height is written as 0. */
  public void rectangle(double x, double y, double width, double height, String fill) {
    begin("rect", "x", x, "y", y);
    attributes("width", Math.max(0, width), "height", Math.max(0, height), "fill", fill);
    svg.append("/>\n");
  }

  /**
   * Adds a path.
   *
   * @param data the value of its attribute {@code d}
   */
  public void path(String data, Object... style) {
    begin("path", "d", data);
    attributes(style);
    svg.append("/>\n");
  }

  /** Adds a circle. */
  public void circle(double x, double y, double radius, Object... style) {
    begin("circle", "cx", x, "cy", y, "r", radius);
    attributes(style);
    svg.append("/>\n");
  }

  /** Adds a text element; y is the coordinate of its baseline. */
  public void text(String words, double x, double y, Object... style) {
    begin("text", "x", x, "y", y);
    attributes(style);
    svg.append('>').append(MarkupEscaper.text(words)).append("</text>\n");
  }

  private void begin(String name, Object... attributes) {
    svg.append('<').append(name);
    attributes(attributes);
  }

  private void attributes(Object... attributes) {
    for (int i = 0; i < attributes.length; i += 2) {
      String value =
          attributes[i + 1] instanceof Double number
              ? number(number)
              : attributes[i + 1].toString();
      if (!value.isEmpty()) {
        svg.append(' ').append(attributes[i]).append("=\"");
        svg.append(MarkupEscaper.attribute(value)).append('"');
      }
    }
  }

  /** Returns the value of {@code d} for a polyline through points of x and y. */
  public String line(List<double[]> points) {
    StringBuilder data = new StringBuilder();
    for (double[] point : points) {
      data.append(data.isEmpty() ? 'M' : 'L').append(number(point[0])).append(' ');
      data.append(number(point[1]));
    }
    return data.toString();
  }

  /** Formats a number with the drawing's precision. */
  private String number(double value) {
    return precision.of(value);
  }

  /** Ends the drawing and returns its text. */
  public String finish() {
    return svg.append("</svg>\n").toString();
  }
}
