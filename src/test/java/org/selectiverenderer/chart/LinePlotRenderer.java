package org.selectiverenderer.chart;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.chart.LinePlot.Curve;
import org.selectiverenderer.chart.LinePlot.Point;

/** Draws a {@link LinePlot}. */
final class LinePlotRenderer {
  private static final int PLOT = 340;
  private static final int ABOVE = 26;
  private static final int FOOT = 58;
  private static final double LONGEST_NAME = 220;

  /** Between the base lines of two names. */
  private static final double NAME = 18;

  private static final String PROPORTION = "in proportion";

  /** A text beside the plot, and the end of the line that it names. */
  private record Name(String text, ChartColour ink, ChartColour line, double x, double y) {}

  private final LinePlot plot;
  private final PlotHeader head;
  private final SizedFont label;
  private final SizedFont small;
  private final double left;
  private final double right;
  private final double top;
  private final double bottom;
  private final LogAxis xs;
  private final LogAxis ys;
  private final SvgCanvas canvas;

  LinePlotRenderer(LinePlot plot) {
    this.plot = plot;
    head = new PlotHeader(plot.title(), plot.subtitle(), List.of());
    label = head.lettering().label();
    small = head.lettering().small();
    top = head.height() + ABOVE;
    bottom = top + PLOT;
    ys = new LogAxis(points().mapToDouble(Point::y), PLOT);
    double numbers = ys.marks().stream().mapToDouble(m -> small.width(number(m))).max().orElse(0);
    left = Math.rint(PlotHeader.MARGIN + numbers + 9);
    Stream<String> names = Stream.concat(Stream.of(PROPORTION), curves().map(Curve::name));
    double widest = names.mapToDouble(label::width).max().orElse(0);
    right = PlotHeader.WIDTH - PlotHeader.MARGIN - Math.rint(Math.min(LONGEST_NAME, widest)) - 16;
    xs = new LogAxis(points().mapToDouble(Point::x), right - left);
    canvas = new SvgCanvas(PlotHeader.WIDTH, (int) bottom + FOOT, plot.title());
  }

  private Stream<Curve> curves() {
    return plot.curves().stream();
  }

  private Stream<Point> points() {
    return curves().flatMap(curve -> curve.points().stream());
  }

  private static String number(double value) {
    return PlotNumberFormat.of(value);
  }

  String svg() {
    canvas.rectangle(0, 0, PlotHeader.WIDTH, bottom + FOOT, ChartColour.PAPER);
    head.draw(canvas);
    axes();
    Optional<Name> proportion = proportion();
    for (int i = 0; i < plot.curves().size(); i++) {
      curve(plot.curves().get(i), SeriesPalette.of(i));
    }
    names(proportion);
    return canvas.finish();
  }

  private void axes() {
    for (double mark : ys.marks()) {
      double y = Math.rint(bottom - ys.at(mark));
      canvas.rectangle(left, y, right - left, 1, ChartColour.GRID);
      String text = number(mark);
      canvas.text(text, left - 8 - small.width(text), y + 4.5, small, ChartColour.FAINT_INK);
    }
    for (double mark : xs.marks()) {
      double x = Math.rint(left + xs.at(mark));
      canvas.rectangle(x, top, 1, PLOT + 5, ChartColour.GRID);
      String text = number(mark);
      canvas.text(text, x - small.width(text) / 2, bottom + 21, small, ChartColour.FAINT_INK);
    }
    canvas.rectangle(left, bottom, right - left, 1, ChartColour.FAINT_INK);
    canvas.text(plot.up(), PlotHeader.MARGIN, top - 14, small, ChartColour.INK);
    double x = (left + right - small.width(plot.across())) / 2;
    canvas.text(plot.across(), x, bottom + 43, small, ChartColour.INK);
  }

  /** From the lower left corner, until it leaves the plot upwards or to the right. */
  private Optional<Name> proportion() {
    double times = Math.min(xs.highest() / xs.lowest(), ys.highest() / ys.lowest());
    double x = left + xs.at(xs.lowest() * times);
    double y = bottom - ys.at(ys.lowest() * times);
    canvas.line(left, bottom, x, y, 1, ChartColour.GREY);
    if (x > right - 1) {
      return Optional.of(new Name(PROPORTION, ChartColour.FAINT_INK, ChartColour.GREY, x, y));
    }
    canvas.text(PROPORTION, x - small.width(PROPORTION) / 2, top - 6, small, ChartColour.FAINT_INK);
    return Optional.empty();
  }

  private void curve(Curve curve, ChartColour colour) {
    List<double[]> at = new ArrayList<>();
    for (Point point : curve.points()) {
      at.add(new double[] {left + xs.at(point.x()), bottom - ys.at(point.y())});
    }
    for (int i = 1; i < at.size(); i++) {
      canvas.line(at.get(i - 1)[0], at.get(i - 1)[1], at.get(i)[0], at.get(i)[1], 2.2, colour);
    }
    canvas.dots(at, 3.6, colour, 1);
  }

  /** Beside the lines' ends, moved apart where they would meet. */
  private void names(Optional<Name> proportion) {
    List<Name> names = new ArrayList<>(proportion.stream().toList());
    for (int i = 0; i < plot.curves().size(); i++) {
      Curve curve = plot.curves().get(i);
      double x = left + xs.at(curve.last().x());
      double y = bottom - ys.at(curve.last().y());
      names.add(new Name(curve.name(), ChartColour.INK, SeriesPalette.of(i), x, y));
    }
    names.sort(Comparator.comparingDouble(Name::y));
    double[] y = names.stream().mapToDouble(Name::y).toArray();
    for (int i = 1; i < y.length; i++) {
      y[i] = Math.max(y[i], y[i - 1] + NAME);
    }
    double below = bottom;
    for (int i = y.length - 1; i >= 0; i--) {
      y[i] = Math.min(y[i], below);
      below = y[i] - NAME;
    }
    for (int i = 0; i < y.length; i++) {
      Name name = names.get(i);
      canvas.line(name.x(), name.y(), right + 12, y[i], 1, name.line());
      String text = label.fit(name.text(), LONGEST_NAME - 4);
      canvas.text(text, right + 16, y[i] + 5, label, name.ink());
    }
  }
}
