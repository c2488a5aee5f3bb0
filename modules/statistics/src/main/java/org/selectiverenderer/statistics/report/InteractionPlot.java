package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.chart.SizedFont;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.chart.TickStep;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.MarginalMean;
import org.selectiverenderer.statistics.anova.Subject;

/**
 * Draws an interaction plot: estimated marginal means over the groups, a line for each level of the
 * within factor, as in Figs 95, 99 and 100 of the thesis, with confidence intervals and a point for
 * each participant, which those lack.
 */
final class InteractionPlot {
  private static final int WIDTH = 460;
  private static final int HEIGHT = 330;
  private static final int LEFT = 52;
  private static final int RIGHT = 14;
  private static final int TOP = 46;
  private static final int BOTTOM = 44;
  private static final double DODGE = 26;
  private static final double SPREAD = 8;
  private static final List<ChartColour> LINES =
      List.of(
          ChartColour.BLUE,
          ChartColour.GREEN,
          ChartColour.VERMILION,
          ChartColour.ORANGE,
          ChartColour.SKY,
          ChartColour.PURPLE);

  private final SizedFont plain;
  private final SizedFont bold;

  InteractionPlot() {
    FontLibrary fonts = new FontLibrary();
    plain = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), 12, false);
    bold = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), 13, true);
  }

  /** Returns an SVG element of 460 x 330 pixels, and more where the legend has several rows. */
  String svg(Anova anova, String title) {
    Legend legend = new Legend(anova.design());
    return draw(SvgCanvas.inline(WIDTH, HEIGHT + legend.more(), title), anova, title, legend);
  }

  /** Returns the plot as a complete SVG file. */
  String file(Anova anova, String title) {
    Legend legend = new Legend(anova.design());
    return draw(new SvgCanvas(WIDTH, HEIGHT + legend.more(), title), anova, title, legend);
  }

  private String draw(SvgCanvas canvas, Anova anova, String title, Legend legend) {
    canvas.rectangle(0, 0, WIDTH, HEIGHT + legend.more(), ChartColour.PAPER);
    canvas.text(bold.fit(title, WIDTH - LEFT - RIGHT), LEFT, 16, bold, ChartColour.INK);
    new Drawing(anova, canvas, legend).draw();
    return canvas.finish();
  }

  /** The names of the levels within participants, in as many rows as they need. */
  private final class Legend {
    private static final int ROW = 18;
    private static final int LINE = 21;
    private static final int GAP = 19;

    private final List<String> names = new ArrayList<>();
    private final List<double[]> places = new ArrayList<>();
    private int rows = 1;

    Legend(FactorialDesign design) {
      List<String> levels = design.within().levels();
      double x = LEFT;
      for (int level = 0; levels.size() > 1 && level < levels.size(); level++) {
        String name = plain.fit(levels.get(level), WIDTH - LEFT - RIGHT - LINE);
        double width = LINE + plain.width(name);
        if (x > LEFT && x + width > WIDTH - RIGHT) {
          x = LEFT;
          rows++;
        }
        names.add(name);
        places.add(new double[] {x, 27 + ROW * (rows - 1)});
        x += width + GAP;
      }
    }

    /** Returns the height of the rows after the first one. */
    int more() {
      return ROW * (rows - 1);
    }

    void draw(SvgCanvas canvas) {
      for (int level = 0; level < names.size(); level++) {
        double x = places.get(level)[0];
        double y = places.get(level)[1];
        canvas.rectangle(x, y, 16, 3, colour(level));
        canvas.text(names.get(level), x + LINE, y + 6, plain, ChartColour.INK);
      }
    }
  }

  private static ChartColour colour(int level) {
    return LINES.get(level % LINES.size());
  }

  /** The drawing of one plot, with its scale. */
  private final class Drawing {
    private final SvgCanvas canvas;
    private final Legend legend;
    private final int top;
    private final int height;
    private final FactorialDesign design;
    private final List<MarginalMean> means;
    private final int groups;
    private final int levels;
    private final double low;
    private final double high;
    private final double step;

    Drawing(Anova anova, SvgCanvas canvas, Legend legend) {
      this.canvas = canvas;
      this.legend = legend;
      top = TOP + legend.more();
      height = HEIGHT + legend.more();
      design = anova.design();
      groups = design.between().levels().size();
      levels = design.within().levels().size();
      means =
          anova.means().stream()
              .filter(mean -> mean.levels().size() == design.factors().size())
              .toList();
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (Subject subject : design.subjects()) {
        for (double value : subject.values()) {
          least = Math.min(least, value);
          most = Math.max(most, value);
        }
      }
      for (MarginalMean mean : means) {
        least = Math.min(least, mean.low());
        most = Math.max(most, mean.high());
      }
      double range = most > least ? most - least : 1;
      step = TickStep.of(range);
      low = Math.floor(least / step) * step;
      high = Math.max(Math.ceil(most / step) * step, low + step);
    }

    void draw() {
      axes();
      legend.draw(canvas);
      for (int level = 0; level < levels; level++) {
        points(level);
      }
      for (int level = 0; level < levels; level++) {
        line(level);
      }
    }

    private void axes() {
      int marks = (int) Math.round((high - low) / step);
      for (int i = 0; i <= marks; i++) {
        double value = low + i * step;
        double y = Math.rint(y(value));
        canvas.rectangle(LEFT, y, WIDTH - LEFT - RIGHT, 1, ChartColour.GRID);
        String number = number(value);
        canvas.text(number, LEFT - 7 - plain.width(number), y + 4, plain, ChartColour.FAINT_INK);
      }
      if (low < 0 && high > 0) {
        canvas.rectangle(LEFT, Math.rint(y(0)), WIDTH - LEFT - RIGHT, 1, ChartColour.GREY);
      }
      double slot = (double) (WIDTH - LEFT - RIGHT) / groups;
      for (int group = 0; group < groups; group++) {
        String count = "n = " + design.group(group).size();
        String name = count;
        if (groups > 1) {
          double room = slot - 8 - plain.width(" (" + count + ")");
          name = plain.fit(design.between().levels().get(group), room) + " (" + count + ")";
        }
        double x = LEFT + slot * (group + 0.5) - plain.width(name) / 2;
        canvas.text(name, x, height - BOTTOM + 20, plain, ChartColour.INK);
      }
      if (groups == 1) {
        return;
      }
      String axis = plain.fit(design.between().name(), WIDTH - LEFT - RIGHT);
      double middle = LEFT + (WIDTH - LEFT - RIGHT) / 2.0;
      canvas.text(axis, middle - plain.width(axis) / 2, height - 8, plain, ChartColour.FAINT_INK);
    }

    private String number(double value) {
      int decimals = Math.max(0, (int) Math.ceil(-Math.log10(step) - 1e-9));
      String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
      return text.matches("-0(\\.0+)?") ? text.substring(1) : text.replace('-', '\u2212');
    }

    private void points(int level) {
      List<double[]> points = new ArrayList<>();
      int[] counts = new int[groups];
      for (Subject subject : design.subjects()) {
        // The golden ratio spreads any number of points evenly.
        double share = (counts[subject.group()]++ * 0.6180339887) % 1;
        double x = x(subject.group(), level) + (share - 0.5) * 2 * SPREAD;
        points.add(new double[] {x, y(subject.values().get(level))});
      }
      canvas.dots(points, 2.2, colour(level), 0.45);
    }

    private void line(int level) {
      double[] before = {};
      for (int group = 0; group < groups; group++) {
        MarginalMean mean = mean(group, level);
        double x = x(group, level);
        double y = y(mean.mean());
        if (before.length > 0) {
          canvas.line(before[0], before[1], x, y, 1.5, colour(level));
        }
        canvas.line(x, y(mean.low()), x, y(mean.high()), 2, colour(level));
        for (double end : new double[] {mean.low(), mean.high()}) {
          canvas.line(x - 5, y(end), x + 5, y(end), 2, colour(level));
        }
        canvas.dots(List.of(new double[] {x, y}), 4.5, colour(level), 1);
        before = new double[] {x, y};
      }
    }

    private MarginalMean mean(int group, int level) {
      Optional<String> within =
          levels > 1 ? Optional.of(design.within().levels().get(level)) : Optional.empty();
      Optional<String> between =
          groups > 1 ? Optional.of(design.between().levels().get(group)) : Optional.empty();
      return means.stream()
          .filter(mean -> mean.within().equals(within) && mean.between().equals(between))
          .findFirst()
          .orElseThrow();
    }

    private double x(int group, int level) {
      double slot = (double) (WIDTH - LEFT - RIGHT) / groups;
      double apart = Math.min(DODGE, (slot - 2 * SPREAD) / levels);
      return LEFT + slot * (group + 0.5) + apart * (level - (levels - 1) / 2.0);
    }

    private double y(double value) {
      return top + (height - top - BOTTOM) * (high - value) / (high - low);
    }
  }
}
