package org.selectiverenderer.chart;

import java.util.List;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.chart.BarChart.Bar;

/** Draws bar charts one below the other. */
final class BarChartPage {
  static final int WIDTH = 1200;
  private static final int MARGIN = 40;
  private static final int ROW = 28;
  private static final int BAR = 18;

  /** The height of title and subtitle, above the first bar. */
  private static final int HEAD = 72;

  /** The height of the axis's numbers, below the last bar. */
  private static final int FOOT = 36;

  private static final double LONGEST_LABEL = 380;

  private final List<BarChart> charts;
  private final SizedFont title;
  private final SizedFont label;
  private final SizedFont small;

  BarChartPage(List<BarChart> charts) {
    this.charts = List.copyOf(charts);
    Lettering lettering = Lettering.of(22, 15, 13);
    title = lettering.title();
    label = lettering.label();
    small = lettering.small();
  }

  /** Returns the height of all charts in pixels. */
  long height() {
    return charts.stream().mapToLong(BarChartPage::height).sum() + MARGIN;
  }

  private static long height(BarChart chart) {
    return MARGIN + HEAD + (long) ROW * chart.bars().size() + FOOT;
  }

  void draw(Canvas canvas) {
    canvas.rectangle(0, 0, WIDTH, height(), ChartColour.PAPER);
    long top = 0;
    for (BarChart chart : charts) {
      draw(chart, canvas, top + MARGIN);
      top += height(chart);
    }
  }

  private void draw(BarChart chart, Canvas canvas, double top) {
    double inside = WIDTH - 2.0 * MARGIN;
    canvas.text(title.fit(chart.title(), inside), MARGIN, top + 22, title, ChartColour.INK);
    canvas.text(
        label.fit(chart.subtitle(), inside), MARGIN, top + 48, label, ChartColour.FAINT_INK);
    double labels = 0;
    double figures = 0;
    for (Bar bar : chart.bars()) {
      labels = Math.max(labels, Math.min(LONGEST_LABEL, label.width(bar.label())));
      figures = Math.max(figures, label.width(bar.figure()));
    }
    double left = Math.rint(MARGIN + labels + 12); // lines on whole pixels are sharp
    double right = WIDTH - MARGIN - Math.max(figures + 10, 40);
    double scale = (right - left) / chart.reach();
    double barsTop = top + HEAD;
    double barsBottom = barsTop + (double) ROW * chart.bars().size();
    new BarAxis(chart.reach(), left, scale)
        .draw(canvas, barsTop, barsBottom, small, value -> number(value) + chart.unit());
    for (int i = 0; i < chart.bars().size(); i++) {
      Bar bar = chart.bars().get(i);
      double y = barsTop + (double) ROW * i + (ROW - BAR) / 2.0;
      String text = label.fit(bar.label(), LONGEST_LABEL);
      canvas.text(text, left - 12 - label.width(text), y + 14.5, label, ChartColour.INK);
      double length = bar.value() * scale;
      canvas.rectangle(left, y, length, BAR, bar.colour());
      double behind = left + length + 7;
      canvas.rectangle(behind - 3, y, label.width(bar.figure()) + 6, BAR, ChartColour.PAPER);
      canvas.text(bar.figure(), behind, y + 14.5, label, ChartColour.INK);
    }
    canvas.rectangle(left - 1, barsTop, 1, barsBottom - barsTop, ChartColour.FAINT_INK);
  }

  private static String number(double value) {
    return value == Math.rint(value)
        ? DecimalText.grouped((long) value)
        : Float.toString((float) value);
  }
}
