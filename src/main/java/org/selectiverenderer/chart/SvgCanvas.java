package org.selectiverenderer.chart;

import java.util.List;
import java.util.Locale;

/**
 * Draws SVG 1.1. Text stays text; its length is stated, so that nothing overlaps in a viewer that
 * lacks the font.
 */
public final class SvgCanvas implements Canvas {
  private final StringBuilder svg = new StringBuilder();

  /** A file of its own. */
  public SvgCanvas(int width, int height, String title) {
    this(width, height, title, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
  }

  private SvgCanvas(int width, int height, String title, String prologue) {
    svg.append(prologue);
    svg.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d"
                + " %d\" font-family=\"'DejaVu Sans', Verdana, sans-serif\">%n",
            width,
            height,
            width,
            height));
    svg.append("<title>").append(escaped(title)).append("</title>\n");
  }

  /** A picture within an HTML page. */
  public static SvgCanvas inline(int width, int height, String title) {
    return new SvgCanvas(width, height, title, "");
  }

  /** A straight line. */
  public void line(double x1, double y1, double x2, double y2, double width, Colour colour) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<path d=\"M%s %sL%s %s\" stroke=\"%s\" stroke-width=\"%s\"/>%n",
            number(x1),
            number(y1),
            number(x2),
            number(y2),
            colour.hex(),
            number(width)));
  }

  /**
   * Round dots of one colour.
   *
   * @param points x, y of each
   * @param opacity from 0 to 1
   */
  public void dots(List<double[]> points, double radius, Colour colour, double opacity) {
    StringBuilder path = new StringBuilder();
    for (double[] point : points) {
      path.append('M').append(number(point[0])).append(' ').append(number(point[1])).append("h0");
    }
    svg.append(
        String.format(
            Locale.ROOT,
            "<path d=\"%s\" stroke=\"%s\" stroke-width=\"%s\" stroke-linecap=\"round\""
                + " stroke-opacity=\"%s\"/>%n",
            path,
            colour.hex(),
            number(2 * radius),
            number(opacity)));
  }

  @Override
  public void rectangle(double x, double y, double width, double height, Colour colour) {
    svg.append(
        String.format(
            Locale.ROOT,
            "<rect x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\" fill=\"%s\"/>%n",
            number(x),
            number(y),
            number(width),
            number(height),
            colour.hex()));
  }

  @Override
  public void text(String text, double x, double y, Lettering lettering, Colour colour) {
    if (text.isBlank()) {
      return;
    }
    svg.append(
        String.format(
            Locale.ROOT,
            "<text x=\"%s\" y=\"%s\" font-size=\"%s\"%s fill=\"%s\" textLength=\"%s\""
                + " lengthAdjust=\"spacingAndGlyphs\">%s</text>%n",
            number(x),
            number(y),
            number(lettering.size()),
            lettering.bold() ? " font-weight=\"bold\"" : "",
            colour.hex(),
            number(lettering.width(text)),
            escaped(text)));
  }

  /** The file's text; nothing is drawn afterwards. */
  public String finish() {
    return svg.append("</svg>\n").toString().replace("\r\n", "\n");
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.2f", value);
    return text.replaceFirst("\\.?0+$", "");
  }

  /** As XML text; characters that XML does not know become spaces. */
  private static String escaped(String text) {
    StringBuilder escaped = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '&' -> escaped.append("&amp;");
                default ->
                    escaped.appendCodePoint(
                        c < 0x20 || c == 0xfffe || c == 0xffff || c >= 0xd800 && c < 0xe000
                            ? ' '
                            : c);
              }
            });
    return escaped.toString();
  }
}
