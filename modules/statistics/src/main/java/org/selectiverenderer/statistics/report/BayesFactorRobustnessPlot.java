package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.chart.SizedFont;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;

/** Draws the Bayes factors of effects as functions of the prior scale r, on a logarithmic axis. */
final class BayesFactorRobustnessPlot {
  private static final int WIDTH = 460;
  private static final int LEFT = 62;
  private static final int RIGHT = 14;
  private static final int TOP = 28;
  private static final int PLOT = 230;
  private static final int LINE = 17;
  private static final int BOTTOM = 52;

  /** The axis ends at this power of ten; evidence beyond it is practically certain. */
  private static final int MOST_TENS = 6;

  private static final List<ChartColour> LINES =
      List.of(
          ChartColour.BLUE,
          ChartColour.GREEN,
          ChartColour.VERMILION,
          ChartColour.ORANGE,
          ChartColour.SKY,
          ChartColour.PURPLE,
          ChartColour.GREY);

  private BayesFactorRobustnessPlot() {}

  /** Returns an SVG element 460 pixels wide; empty where there are no Bayes factors. */
  static Optional<String> svg(List<EffectBayesFactors> evidence) {
    List<EffectBayesFactors> drawn =
        evidence.stream().filter(found -> !found.robustness().isEmpty()).toList();
    if (drawn.isEmpty()) {
      return Optional.empty();
    }
    FontLibrary fonts = new FontLibrary();
    SizedFont plain = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), 12, false);
    SizedFont bold = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), 13, true);
    int height = TOP + PLOT + BOTTOM + LINE * drawn.size();
    String title = "Bayes factors and the width of their prior";
    SvgCanvas canvas = SvgCanvas.inline(WIDTH, height, title);
    canvas.rectangle(0, 0, WIDTH, height, ChartColour.PAPER);
    canvas.text(title, LEFT, 16, bold, ChartColour.INK);
    int low = -1;
    int high = 1;
    for (EffectBayesFactors found : drawn) {
      for (EffectBayesFactors.Point point : found.robustness()) {
        low = Math.min(low, (int) Math.floor(tens(point.bf01())));
        high = Math.max(high, (int) Math.ceil(tens(point.bf01())));
      }
    }
    axes(canvas, plain, low, high);
    for (int i = 0; i < drawn.size(); i++) {
      ChartColour colour = LINES.get(i % LINES.size());
      List<double[]> points = new ArrayList<>();
      for (EffectBayesFactors.Point point : drawn.get(i).robustness()) {
        points.add(new double[] {x(point.scale()), y(tens(point.bf01()), low, high)});
      }
      for (int p = 1; p < points.size(); p++) {
        double[] from = points.get(p - 1);
        double[] to = points.get(p);
        canvas.line(from[0], from[1], to[0], to[1], 1.5, colour);
      }
      canvas.dots(points, 3.5, colour, 1);
      double y = TOP + PLOT + BOTTOM + LINE * i;
      canvas.rectangle(LEFT, y - 4, 16, 3, colour);
      canvas.text(
          plain.fit(drawn.get(i).term().name(), WIDTH - LEFT - RIGHT - 24),
          LEFT + 22,
          y,
          plain,
          ChartColour.INK);
    }
    return Optional.of(canvas.finish());
  }

  private static void axes(SvgCanvas canvas, SizedFont plain, int low, int high) {
    for (int power = low; power <= high; power++) {
      double y = Math.rint(y(power, low, high));
      canvas.rectangle(
          LEFT, y, WIDTH - LEFT - RIGHT, 1, power == 0 ? ChartColour.GREY : ChartColour.GRID);
      String number = power >= 0 ? "1" + "0".repeat(power) : "1/1" + "0".repeat(-power);
      canvas.text(number, LEFT - 7 - plain.width(number), y + 4, plain, ChartColour.FAINT_INK);
    }
    for (double r : new double[] {0.25, 0.5, 0.75, 1, 1.25, 1.5}) {
      String number = String.format(Locale.ROOT, "%.2f", r);
      canvas.line(x(r), TOP + PLOT, x(r), TOP + PLOT + 4, 1, ChartColour.FAINT_INK);
      canvas.text(
          number, x(r) - plain.width(number) / 2, TOP + PLOT + 16, plain, ChartColour.FAINT_INK);
    }
    String axis = "BF01 (above 1: for no effect) over the width r";
    canvas.text(axis, LEFT, TOP + PLOT + 30, plain, ChartColour.FAINT_INK);
  }

  private static double tens(double bf01) {
    return Math.max(-MOST_TENS, Math.min(MOST_TENS, Math.log10(Math.max(bf01, 1e-300))));
  }

  private static double x(double scale) {
    return LEFT + (WIDTH - LEFT - RIGHT - 20) * scale / 1.5;
  }

  private static double y(double tens, int low, int high) {
    return TOP + PLOT * (high - tens) / (high - low);
  }
}
