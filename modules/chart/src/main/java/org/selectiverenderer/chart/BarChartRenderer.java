package org.selectiverenderer.chart;

import java.util.List;
import java.util.function.DoubleFunction;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.chart.BarChart.Bar;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;

/** Draws bar charts one below the other. */
final class BarChartRenderer {
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

  BarChartRenderer(List<BarChart> charts) {
    this.charts = List.copyOf(charts);
    ChartFonts lettering = ChartFonts.of(22, 15, 13);
    title = lettering.title();
    label = lettering.label();
    small = lettering.small();
  }

  /** Returns the height of all charts in pixels. */
  long height() {
    return charts.stream().mapToLong(BarChartRenderer::height).sum() + MARGIN;
  }

  private static long height(BarChart chart) {
    return MARGIN + HEAD + (long) ROW * chart.bars().size() + FOOT;
  }

  void draw(ChartCanvas canvas) {
    canvas.rectangle(0, 0, WIDTH, height(), ChartColour.PAPER);
    long top = 0;
    for (BarChart chart : charts) {
      draw(chart, canvas, top + MARGIN);
      top += height(chart);
    }
  }

  private void draw(BarChart chart, ChartCanvas canvas, double top) {
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
    new ValueAxis(chart.reach(), left, scale)
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
        ? DecimalFormatter.grouped((long) value)
        : Float.toString((float) value);
  }

  /**
   * The value axis of a chart with horizontal bars.
   *
   * @param reach the largest value on it, above 0
   * @param left x of the value 0, in pixels
   * @param scale pixels per unit of value
   */
  record ValueAxis(double reach, double left, double scale) {
    /**
     * Draws a grid line for each tick, and its number where there is room for it.
     *
     * @param top y of the upper ends of the grid lines
     * @param bottom y of the lower end of the bars; the numbers are below
     */
    void draw(
        ChartCanvas canvas,
        double top,
        double bottom,
        SizedFont small,
        DoubleFunction<String> number) {
      double step = TickStep.of(reach);
      double free = Double.NEGATIVE_INFINITY; // right of the last number
      for (int i = 0; i * step <= reach * (1 + 1e-9); i++) {
        double x = Math.rint(left + i * step * scale);
        canvas.rectangle(x, top, 1, bottom - top + 5, ChartColour.GRID);
        String text = number.apply(i * step);
        double half = small.width(text) / 2;
        if (x - half > free) {
          canvas.text(text, x - half, bottom + 22, small, ChartColour.FAINT_INK);
          free = x + half + 12;
        }
      }
    }
  }

  /**
   * The fonts of a page of charts.
   *
   * @param title font of chart titles
   * @param label font of labels
   * @param small font of the numbers along the axes
   */
  record ChartFonts(SizedFont title, SizedFont label, SizedFont small) {
    /** Creates fonts of these sizes, in pixels per em. */
    static ChartFonts of(double title, double label, double small) {
      FontLibrary fonts = new FontLibrary();
      return new ChartFonts(
          new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), title, true),
          new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), label, false),
          new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), small, false));
    }
  }
}
