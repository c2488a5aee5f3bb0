package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.chart.SizedFont;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.statistics.detection.EmpiricalRoc;
import org.selectiverenderer.statistics.detection.UnequalVarianceFit;
import org.selectiverenderer.statistics.study.RatingAnalysis;

/** Draws the ROC of each condition: its points, and the fitted curve where there is one. */
final class RocPlot {
  private static final int SIDE = 300;
  private static final int LEFT = 52;
  private static final int TOP = 34;
  private static final int WIDTH = LEFT + SIDE + 14;
  private static final int LINE = 18;
  private static final int FOOT = 50;
  private static final int CURVE = 100;
  private static final List<ChartColour> LINES =
      List.of(
          ChartColour.BLUE,
          ChartColour.VERMILION,
          ChartColour.GREEN,
          ChartColour.ORANGE,
          ChartColour.PURPLE,
          ChartColour.SKY);

  private final SizedFont plain;
  private final SizedFont bold;

  RocPlot() {
    FontLibrary fonts = new FontLibrary();
    plain = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), 12, false);
    bold = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), 13, true);
  }

  /** Returns an SVG element for a page. */
  String svg(List<RatingAnalysis> scores, String title) {
    return draw(SvgCanvas.inline(WIDTH, height(scores), title), scores, title);
  }

  /** Returns a complete SVG file. */
  String file(List<RatingAnalysis> scores, String title) {
    return draw(new SvgCanvas(WIDTH, height(scores), title), scores, title);
  }

  private static int height(List<RatingAnalysis> scores) {
    return TOP + SIDE + FOOT + LINE * scores.size() + 6;
  }

  private String draw(SvgCanvas canvas, List<RatingAnalysis> scores, String title) {
    canvas.rectangle(0, 0, WIDTH, height(scores), ChartColour.PAPER);
    canvas.text(bold.fit(title, WIDTH - LEFT), LEFT, 18, bold, ChartColour.INK);
    axes(canvas);
    for (int i = 0; i < scores.size(); i++) {
      ChartColour colour = LINES.get(i % LINES.size());
      RatingAnalysis score = scores.get(i);
      curve(canvas, score.fit(), colour);
      List<double[]> points = new ArrayList<>();
      for (EmpiricalRoc.Point point : score.roc().points()) {
        points.add(new double[] {x(point.falseAlarmRate()), y(point.hitRate())});
      }
      canvas.dots(points, 3.2, colour, 1);
      double base = TOP + SIDE + FOOT + LINE * (i + 0.7);
      canvas.dots(List.of(new double[] {LEFT + 6, base - 4}), 4, colour, 1);
      String figures = figures(score);
      double room = WIDTH - LEFT - 22 - plain.width(figures);
      canvas.text(
          plain.fit(score.condition(), room) + figures, LEFT + 18, base, plain, ChartColour.INK);
    }
    return canvas.finish();
  }

  /** Returns the text behind the condition's name in the legend. */
  private static String figures(RatingAnalysis score) {
    StringBuilder text = new StringBuilder(" (n = " + score.participants() + ")");
    if (Double.isFinite(score.roc().area())) {
      text.append(String.format(Locale.ROOT, ": AUC %.2f", score.roc().area()));
    }
    if (score.fit().flaw().isEmpty()) {
      text.append(String.format(Locale.ROOT, ", d_a %.2f", score.fit().distance().value()));
    }
    return text.toString().replace('-', '\u2212');
  }

  private void axes(SvgCanvas canvas) {
    for (int i = 0; i <= 4; i++) {
      double share = i / 4.0;
      canvas.rectangle(Math.rint(x(share)), TOP, 1, SIDE, ChartColour.GRID);
      canvas.rectangle(LEFT, Math.rint(y(share)), SIDE, 1, ChartColour.GRID);
      String mark = i == 0 ? "0" : i == 4 ? "1" : String.format(Locale.ROOT, "%.2f", share);
      double half = plain.width(mark) / 2;
      canvas.text(mark, x(share) - half, TOP + SIDE + 16, plain, ChartColour.FAINT_INK);
      canvas.text(mark, LEFT - 7 - 2 * half, y(share) + 4, plain, ChartColour.FAINT_INK);
    }
    canvas.line(x(0), y(0), x(1), y(1), 1, ChartColour.GREY);
    String across = "false alarm rate (hit rate upwards)";
    double middle = LEFT + SIDE / 2.0 - plain.width(across) / 2;
    canvas.text(across, middle, TOP + SIDE + 34, plain, ChartColour.FAINT_INK);
  }

  private static void curve(SvgCanvas canvas, UnequalVarianceFit fit, ChartColour colour) {
    if (fit.flaw().isPresent()) {
      return;
    }
    double[] before = {x(0), y(0)};
    for (int i = 1; i <= CURVE; i++) {
      // Points are closer together at the ends, where the curve bends most.
      double rate = (1 - Math.cos(Math.PI * i / CURVE)) / 2;
      double hit = i == CURVE ? 1 : fit.hitRate(rate);
      double[] next = {x(rate), y(hit)};
      canvas.line(before[0], before[1], next[0], next[1], 1.5, colour);
      before = next;
    }
  }

  private static double x(double rate) {
    return LEFT + SIDE * rate;
  }

  private static double y(double rate) {
    return TOP + SIDE * (1 - rate);
  }
}
