package org.selectiverenderer.chart;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.chart.BarPlot.Group;

/** Lays the bars of a {@link BarPlot} out. */
final class BarPlotRenderer {
  private static final int ROW = 23;
  private static final int BAR = 19;
  private static final int BETWEEN_GROUPS = 13;
  private static final int FOOT = 40;
  private static final double LONGEST_LABEL = 240;

  /** From the top of a bar to the base line of the text in it. */
  private static final int BASE = 14;

  private final BarPlot plot;
  private final PlotHeader head;
  private final SizedFont label;
  private final SizedFont small;

  BarPlotRenderer(BarPlot plot) {
    this.plot = plot;
    head = new PlotHeader(plot.title(), plot.subtitle(), plot.series());
    label = head.lettering().label();
    small = head.lettering().small();
  }

  String svg() {
    int bars = plot.groups().stream().mapToInt(group -> height(group) + BETWEEN_GROUPS).sum();
    int height = head.height() + bars + FOOT;
    SvgCanvas canvas = new SvgCanvas(PlotHeader.WIDTH, height, plot.title());
    canvas.rectangle(0, 0, PlotHeader.WIDTH, height, ChartColour.PAPER);
    head.draw(canvas);
    double labels = widest(plot.groups().stream().map(Group::label).toList());
    double left = Math.rint(PlotHeader.MARGIN + Math.min(LONGEST_LABEL, labels) + 12);
    double figures = widest(plot.groups().stream().flatMap(g -> figures(g).stream()).toList());
    double right = PlotHeader.WIDTH - PlotHeader.MARGIN - Math.max(figures + 10, 30);
    double scale = (right - left) / plot.reach();
    double top = head.height();
    new BarChartRenderer.ValueAxis(plot.reach(), left, scale)
        .draw(canvas, top, top + bars, small, value -> PlotNumberFormat.of(value) + plot.unit());
    for (Group group : plot.groups()) {
      draw(group, canvas, left, scale, top + BETWEEN_GROUPS / 2.0);
      top += height(group) + BETWEEN_GROUPS;
    }
    canvas.rectangle(left - 1, head.height(), 1, bars, ChartColour.FAINT_INK);
    return canvas.finish();
  }

  private double widest(List<String> texts) {
    return texts.stream().mapToDouble(label::width).max().orElse(0);
  }

  /** What stands behind the bars of a group, from top to bottom. */
  private List<String> figures(Group group) {
    List<String> figures = new ArrayList<>();
    if (plot.stacked()) {
      figures.add(PlotNumberFormat.of(group.sum()) + plot.unit());
    } else {
      for (String series : plot.series()) {
        Double value = group.values().get(series);
        figures.add(value == null ? "not measured" : PlotNumberFormat.of(value) + plot.unit());
      }
    }
    return figures;
  }

  private int height(Group group) {
    return ROW * figures(group).size();
  }

  private void draw(Group group, SvgCanvas canvas, double left, double scale, double top) {
    String name = label.fit(group.label(), LONGEST_LABEL);
    double middle = top + height(group) / 2.0 + 5;
    canvas.text(name, left - 12 - label.width(name), middle, label, ChartColour.INK);
    List<String> figures = figures(group);
    double end = left;
    for (int i = 0; i < plot.series().size(); i++) {
      double length = group.values().getOrDefault(plot.series().get(i), 0.0) * scale;
      double y = top + (plot.stacked() ? 0 : i * ROW) + (ROW - BAR) / 2.0;
      double from = plot.stacked() ? end : left;
      ChartColour colour = SeriesPalette.of(i);
      canvas.rectangle(from, y, plot.stacked() ? Math.max(0, length - 1) : length, BAR, colour);
      if (plot.stacked()) {
        inside(group.values().getOrDefault(plot.series().get(i), 0.0), canvas, from, y, length, i);
        end += length;
      } else {
        behind(figures.get(i), canvas, from + length, y);
      }
    }
    if (plot.stacked()) {
      behind(figures.get(0), canvas, end, top + (ROW - BAR) / 2.0);
    }
  }

  /** A part's own figure, where there is room for it. */
  private void inside(
      double value, SvgCanvas canvas, double left, double y, double length, int series) {
    String text = PlotNumberFormat.of(value);
    double width = small.width(text);
    if (width + 8 <= length) {
      double x = left + (length - 1 - width) / 2;
      canvas.text(text, x, y + BASE, small, SeriesPalette.lettering(series));
    }
  }

  private void behind(String figure, SvgCanvas canvas, double end, double y) {
    canvas.rectangle(end + 3, y, label.width(figure) + 8, BAR, ChartColour.PAPER);
    canvas.text(figure, end + 7, y + BASE, label, ChartColour.INK);
  }
}
