package org.selectiverenderer.app.replication;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.chart.SizedFont;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.chart.TickStep;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;

/** Draws what is printed beside what comes out: bars of polygons, means with standard errors. */
final class ReplicationCharts {
  private static final int BARS_WIDTH = 800;
  private static final int BAR = 26;
  private static final int LABELS = 280;
  private static final int FIGURES = 90;
  private static final int WIDTH = 360;
  private static final int HEIGHT = 250;
  private static final int LEFT = 46;
  private static final int RIGHT = 10;
  private static final int TOP = 50;
  private static final int BOTTOM = 28;
  private static final List<ChartColour> TYPES =
      List.of(ChartColour.BLUE, ChartColour.GREEN, ChartColour.VERMILION);

  private final SizedFont plain;
  private final SizedFont bold;

  ReplicationCharts() {
    FontLibrary fonts = new FontLibrary();
    plain = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), 12, false);
    bold = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), 13, true);
  }

  /** Draws a bar for each count of the scene, and a mark where print has it. */
  String polygons(List<ReplicationFindings.PolygonRow> rows) {
    int height = 40 + BAR * rows.size() + 6;
    SvgCanvas canvas = SvgCanvas.inline(BARS_WIDTH, height, "Polygons, counted and printed");
    canvas.rectangle(0, 0, BARS_WIDTH, height, ChartColour.PAPER);
    canvas.rectangle(LABELS, 10, 16, 12, ChartColour.SKY);
    canvas.text("counted in the scene", LABELS + 22, 20, plain, ChartColour.INK);
    canvas.rectangle(LABELS + 180, 8, 3, 16, ChartColour.VERMILION);
    canvas.text("printed", LABELS + 190, 20, plain, ChartColour.INK);
    double most =
        rows.stream()
            .mapToLong(row -> Math.max(row.counted().orElse(0), row.total().printed()))
            .max()
            .orElse(1);
    double scale = (BARS_WIDTH - LABELS - FIGURES) / most;
    for (int i = 0; i < rows.size(); i++) {
      ReplicationFindings.PolygonRow row = rows.get(i);
      double y = 40 + BAR * i;
      String label = plain.fit(ReplicationPage.state(row.total()), LABELS - 12);
      canvas.text(label, LABELS - 8 - plain.width(label), y + 14, plain, ChartColour.INK);
      if (row.counted().isPresent()) {
        double counted = row.counted().getAsLong();
        canvas.rectangle(LABELS, y + 2, counted * scale, BAR - 10, ChartColour.SKY);
        canvas.text(
            String.format(Locale.ROOT, "%,d", row.counted().getAsLong()),
            LABELS + Math.max(counted, row.total().printed()) * scale + 8,
            y + 14,
            plain,
            ChartColour.INK);
      }
      canvas.rectangle(
          LABELS + row.total().printed() * scale - 1.5, y - 1, 3, BAR - 4, ChartColour.VERMILION);
    }
    return canvas.finish();
  }

  /**
   * Draws the means of an area by condition: a bar where print has them, a dot with its standard
   * error where the simulation has them.
   *
   * @param rows of one measure at one level of confidence, without totals
   */
  String means(String title, List<ReplicationFindings.ScoreMean> rows) {
    List<String> conditions = rows.stream().map(row -> row.row().condition()).distinct().toList();
    List<String> types = rows.stream().map(row -> row.row().type()).distinct().toList();
    double low = 0;
    double high = 0;
    for (ReplicationFindings.ScoreMean row : rows) {
      low = Math.min(low, Math.min(row.printed(), row.mean() - row.error()));
      high = Math.max(high, Math.max(row.printed(), row.mean() + row.error()));
    }
    double step = TickStep.of(Math.max(high - low, 0.1));
    low = Math.floor(low / step) * step;
    high = Math.ceil(high / step) * step;
    double unit = (HEIGHT - TOP - BOTTOM) / (high - low);
    SvgCanvas canvas = SvgCanvas.inline(WIDTH, HEIGHT, title);
    canvas.rectangle(0, 0, WIDTH, HEIGHT, ChartColour.PAPER);
    canvas.text(title, LEFT, 16, bold, ChartColour.INK);
    legend(canvas, types);
    for (int i = 0; i <= Math.round((high - low) / step); i++) {
      double value = low + i * step;
      double y = TOP + (high - value) * unit;
      boolean zero = Math.abs(value) < step / 2;
      canvas.rectangle(
          LEFT, Math.rint(y), WIDTH - LEFT - RIGHT, 1, zero ? ChartColour.GREY : ChartColour.GRID);
      String number =
          String.format(Locale.ROOT, step < 0.1 ? "%.2f" : "%.1f", zero ? 0 : value)
              .replace('-', '\u2212');
      canvas.text(number, LEFT - 7 - plain.width(number), y + 4, plain, ChartColour.FAINT_INK);
    }
    double slot = (double) (WIDTH - LEFT - RIGHT) / conditions.size();
    for (int i = 0; i < conditions.size(); i++) {
      String name = plain.fit(conditions.get(i), slot - 4);
      double middle = LEFT + slot * (i + 0.5);
      canvas.text(name, middle - plain.width(name) / 2, HEIGHT - 9, plain, ChartColour.INK);
    }
    for (ReplicationFindings.ScoreMean row : rows) {
      int type = types.indexOf(row.row().type());
      double x =
          LEFT
              + slot * (conditions.indexOf(row.row().condition()) + 0.5)
              + 30 * (type - (types.size() - 1) / 2.0);
      double zero = TOP + high * unit;
      ChartColour colour = TYPES.get(type);
      canvas.rectangle(x - 11, zero - row.printed() * unit - 1.5, 22, 3, ChartColour.INK);
      canvas.line(
          x,
          zero - (row.mean() - row.error()) * unit,
          x,
          zero - (row.mean() + row.error()) * unit,
          2,
          colour);
      canvas.dots(List.of(new double[] {x, zero - row.mean() * unit}), 4.5, colour, 1);
    }
    return canvas.finish();
  }

  private void legend(SvgCanvas canvas, List<String> types) {
    canvas.rectangle(LEFT, 29, 18, 3, ChartColour.INK);
    canvas.text("printed", LEFT + 24, 35, plain, ChartColour.INK);
    double x = LEFT + 24 + plain.width("printed") + 18;
    for (int i = 0; i < types.size(); i++) {
      String name = types.get(i).equals("neutral") ? "simulated" : types.get(i);
      canvas.dots(List.of(new double[] {x, 31}), 4.5, TYPES.get(i), 1);
      canvas.text(name, x + 9, 35, plain, ChartColour.INK);
      x += 9 + plain.width(name) + 18;
    }
  }
}
