package org.selectiverenderer.chart;

import java.util.ArrayList;
import java.util.List;

/** Draws the header of a plot: title, subtitle, and the legend on as many lines as it needs. */
final class PlotHeader {
  /** Of a plot, in pixels: what a page shows without shrinking it. */
  static final int WIDTH = 880;

  static final int MARGIN = 24;

  private static final int SWATCH = 13;
  private static final int LEGEND_LINE = 22;

  /** To below the subtitle. */
  private static final int TITLES = 64;

  private record Entry(int index, String name, double x, int line) {}

  private final String title;
  private final String subtitle;
  private final BarChartRenderer.ChartFonts lettering =
      BarChartRenderer.ChartFonts.of(18, 14, 12.5);
  private final List<Entry> legend = new ArrayList<>();

  /**
   * @param series names of the legend; of fewer than two it has none
   */
  PlotHeader(String title, String subtitle, List<String> series) {
    this.title = title;
    this.subtitle = subtitle;
    double x = MARGIN;
    int line = 0;
    for (int i = 0; series.size() > 1 && i < series.size(); i++) {
      String name = lettering.label().fit(series.get(i), WIDTH - 2.0 * MARGIN - SWATCH - 7);
      double width = SWATCH + 7 + lettering.label().width(name);
      if (x > MARGIN && x + width > WIDTH - MARGIN) {
        x = MARGIN;
        line++;
      }
      legend.add(new Entry(i, name, x, line));
      x += width + 22;
    }
  }

  BarChartRenderer.ChartFonts lettering() {
    return lettering;
  }

  /** In pixels, down to where the plot may begin. */
  int height() {
    int lines = legend.isEmpty() ? 0 : legend.get(legend.size() - 1).line() + 1;
    return TITLES + LEGEND_LINE * lines + 12;
  }

  void draw(ChartCanvas canvas) {
    double inside = WIDTH - 2.0 * MARGIN;
    SizedFont bold = lettering.title();
    SizedFont plain = lettering.label();
    canvas.text(bold.fit(title, inside), MARGIN, 32, bold, ChartColour.INK);
    canvas.text(plain.fit(subtitle, inside), MARGIN, 54, plain, ChartColour.FAINT_INK);
    for (Entry entry : legend) {
      double y = TITLES + LEGEND_LINE * entry.line() + 4.0;
      ChartColour colour = SeriesPalette.of(entry.index());
      canvas.rectangle(entry.x(), y, SWATCH, SWATCH, colour);
      canvas.text(entry.name(), entry.x() + SWATCH + 7, y + 11.5, plain, ChartColour.INK);
    }
  }
}
