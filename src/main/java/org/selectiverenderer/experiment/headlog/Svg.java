package org.selectiverenderer.experiment.headlog;

import java.util.List;
import java.util.Locale;

/** Writes a drawing as SVG, pixels from the upper left corner, y down. */
final class Svg {
  private final StringBuilder text = new StringBuilder();

  Svg(int width, int height, String title) {
    text.append(
        String.format(
            Locale.ROOT,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d"
                + " %d\" font-family=\"DejaVu Sans, Arial, sans-serif\">%n<title>%s</title>%n",
            width,
            height,
            width,
            height,
            escape(title)));
    rectangle(0, 0, width, height, "#ffffff");
  }

  void rectangle(double x, double y, double width, double height, String fill) {
    element(
        "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>",
        x, y, Math.max(0, width), Math.max(0, height), fill);
  }

  /**
   * A line through points.
   *
   * @param style further attributes
   */
  void path(List<double[]> points, boolean closed, String style) {
    if (points.isEmpty()) {
      return;
    }
    StringBuilder d = new StringBuilder();
    for (double[] point : points) {
      d.append(
          String.format(Locale.ROOT, "%s%.1f %.1f", d.isEmpty() ? "M" : "L", point[0], point[1]));
    }
    element("<path d=\"%s%s\" %s/>", d, closed ? "Z" : "", style);
  }

  void circle(double x, double y, double radius, String style) {
    element("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" %s/>", x, y, radius, style);
  }

  /**
   * Text from its left end.
   *
   * @param anchor start, middle or end
   */
  void text(String words, double x, double y, double size, String fill, String anchor) {
    element(
        "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.0f\" fill=\"%s\" text-anchor=\"%s\">%s</text>",
        x, y, size, fill, anchor, escape(words));
  }

  private void element(String format, Object... arguments) {
    text.append(String.format(Locale.ROOT, format, arguments)).append('\n');
  }

  private static String escape(String words) {
    return words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  String finish() {
    return text + "</svg>\n";
  }
}
