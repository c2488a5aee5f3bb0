package org.selectiverenderer.study.questionnaire.paper;

import java.util.Locale;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.study.questionnaire.SliderField;

/**
 * Draws a slider for HTML pages: on paper a line of exactly 10 cm, to be marked with a pen and
 * measured with a ruler.
 */
public final class SliderSvg {
  /** Length of the line, and room at each of its ends, in tenths of a millimetre. */
  private static final int LENGTH = 1000;

  private static final int END = 40;

  private SliderSvg() {}

  /** Returns the line between the labels of its ends, with class {@code slider}. */
  public static String figure(SliderField slider) {
    return "<div class=\"slider\"><span>%s</span>%s<span>%s</span></div>\n"
        .formatted(
            MarkupEscaper.attribute(slider.least()),
            svg(slider),
            MarkupEscaper.attribute(slider.most()));
  }

  private static String svg(SliderField slider) {
    boolean labels = !slider.labelled().isEmpty();
    StringBuilder svg =
        new StringBuilder(
            "<svg viewBox=\"0 0 %d %d\" xmlns=\"http://www.w3.org/2000/svg\" stroke=\"#000\">"
                .formatted(LENGTH + 2 * END, labels ? 100 : 60));
    line(svg, END, 30, END + LENGTH, 30);
    line(svg, END, 15, END, 45);
    line(svg, END + LENGTH, 15, END + LENGTH, 45);
    for (int mark : slider.marked()) {
      line(svg, x(slider, mark), 20, x(slider, mark), 40);
    }
    for (int label : slider.labelled()) {
      svg.append(
          "<text x=\"%s\" y=\"85\" text-anchor=\"middle\" font-size=\"34\" stroke=\"none\">%s</text>"
              .formatted(tidy(x(slider, label)), slider.value(label)));
    }
    return svg.append("</svg>").toString();
  }

  private static double x(SliderField slider, int position) {
    return END + (double) LENGTH * position / slider.last();
  }

  private static void line(StringBuilder svg, double x1, double y1, double x2, double y2) {
    svg.append(
        "<line x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\" stroke-width=\"3\"/>"
            .formatted(tidy(x1), tidy(y1), tidy(x2), tidy(y2)));
  }

  private static String tidy(double number) {
    return String.format(Locale.ROOT, "%.1f", number);
  }
}
