package org.selectiverenderer.chart;

import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;

/** Draws a step chart by rectangles, which are sharp in SVG and in pixels. */
final class StepChartRenderer {
  static final int WIDTH = 1200;
  static final int HEIGHT = 480;
  static final List<ChartColour> COLOURS =
      List.of(
          ChartColour.BLUE,
          ChartColour.VERMILION,
          ChartColour.GREEN,
          ChartColour.ORANGE,
          ChartColour.PURPLE,
          ChartColour.SKY);

  private static final int MARGIN = 40;
  private static final int TOP = 130;
  private static final int FOOT = 64;
  private static final double LINE = 2.5;

  private final StepChart chart;
  private final BarChartRenderer.ChartFonts fonts = BarChartRenderer.ChartFonts.of(22, 15, 13);

  StepChartRenderer(StepChart chart) {
    this.chart = chart;
  }

  void draw(ChartCanvas canvas) {
    canvas.rectangle(0, 0, WIDTH, HEIGHT, ChartColour.PAPER);
    double inside = WIDTH - 2.0 * MARGIN;
    canvas.text(
        fonts.title().fit(chart.title(), inside), MARGIN, 46, fonts.title(), ChartColour.INK);
    canvas.text(
        fonts.label().fit(chart.subtitle(), inside),
        MARGIN,
        72,
        fonts.label(),
        ChartColour.FAINT_INK);
    legend(canvas);
    double most = 1e-9;
    double end = 1e-9;
    for (StepChart.Curve curve : chart.curves()) {
      for (StepChart.Step step : curve.steps()) {
        most = Math.max(most, step.value());
        end = Math.max(end, step.t());
      }
    }
    double tick = TickStep.of(most);
    double top = Math.ceil(most / tick - 1e-9) * tick;
    double widest = 0;
    for (int i = 0; i * tick <= top * 1.0001; i++) {
      widest = Math.max(widest, fonts.small().width(number(i * tick)));
    }
    double left = Math.rint(MARGIN + widest + 12);
    double scaleX = (WIDTH - MARGIN - left) / end;
    double scaleY = (HEIGHT - FOOT - TOP) / top;
    for (int i = 0; i * tick <= top * 1.0001; i++) {
      double y = Math.rint(HEIGHT - FOOT - i * tick * scaleY);
      canvas.rectangle(left, y, WIDTH - MARGIN - left, 1, ChartColour.GRID);
      String text = number(i * tick);
      canvas.text(
          text, left - 10 - fonts.small().width(text), y + 4.5, fonts.small(), ChartColour.INK);
    }
    double seconds = TickStep.of(end);
    for (int i = 0; i * seconds <= end * 1.0001; i++) {
      double x = Math.rint(left + i * seconds * scaleX);
      canvas.rectangle(x, HEIGHT - FOOT, 1, 6, ChartColour.FAINT_INK);
      String text = number(i * seconds) + " s";
      double at = Math.min(x - fonts.small().width(text) / 2, WIDTH - fonts.small().width(text));
      canvas.text(text, at, HEIGHT - FOOT + 22, fonts.small(), ChartColour.INK);
    }
    canvas.rectangle(left, HEIGHT - FOOT, WIDTH - MARGIN - left, 1, ChartColour.FAINT_INK);
    for (int i = 0; i < chart.curves().size(); i++) {
      curve(canvas, chart.curves().get(i), COLOURS.get(i), left, scaleX, scaleY);
    }
  }

  private void legend(ChartCanvas canvas) {
    double x = MARGIN;
    double inside = WIDTH - 2.0 * MARGIN;
    double most = Math.min(inside / 3 - 40, inside / chart.curves().size() - 56);
    for (int i = 0; i < chart.curves().size(); i++) {
      String name = fonts.label().fit(chart.curves().get(i).name(), most);
      canvas.rectangle(x, 94, 20, LINE, COLOURS.get(i));
      canvas.text(name, x + 28, 100, fonts.label(), ChartColour.INK);
      x += 28 + fonts.label().width(name) + 28;
    }
  }

  private static void curve(
      ChartCanvas canvas,
      StepChart.Curve curve,
      ChartColour colour,
      double left,
      double scaleX,
      double scaleY) {
    double x = left;
    double y = HEIGHT - FOOT;
    boolean first = true;
    for (StepChart.Step step : curve.steps()) {
      double toX = left + step.t() * scaleX;
      double toY = HEIGHT - FOOT - step.value() * scaleY;
      if (!first) {
        canvas.rectangle(x - LINE / 2, y - LINE / 2, toX - x + LINE, LINE, colour);
        canvas.rectangle(
            toX - LINE / 2, Math.min(y, toY) - LINE / 2, LINE, Math.abs(toY - y) + LINE, colour);
      }
      x = toX;
      y = toY;
      first = false;
    }
  }

  private static String number(double value) {
    return value == Math.rint(value)
        ? DecimalFormatter.grouped((long) value)
        : Float.toString((float) value);
  }
}
