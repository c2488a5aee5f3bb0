package org.selectiverenderer.study.headlog;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.formats.image.SvgWriter;

/** A timeline of dwells: a row for each object, a bar for each dwell. */
final class DwellTimeline {
  private static final int LABELS = 240;
  private static final int ROW = 20;

  /** Maximum number of rows: the objects looked at longest. */
  private static final int ROWS = 24;

  /** Colour of times without a picture. */
  private static final String DARK = "#cccccc";

  private static final String FAINT = "#777777";

  private final String title;
  private final HeadLog log;
  private final DwellSummary looks;
  private final Map<String, String> colours;
  private final List<DwellSummary.ObjectView> rows;

  /**
   * @param colours by the names of objects
   */
  DwellTimeline(String title, HeadLog log, DwellSummary looks, Map<String, String> colours) {
    this.title = title;
    this.log = log;
    this.looks = looks;
    this.colours = colours;
    rows = looks.objects().stream().limit(ROWS).toList();
  }

  /** Returns the height in the drawing, with the space below. */
  double height() {
    return 40.0 + ROW * rows.size() + HeadLogPlot.MARGIN;
  }

  /**
   * Draws the timeline.
   *
   * @param top y of the title's upper edge in the drawing
   */
  void draw(SvgWriter svg, double top) {
    double begin = log.samples().get(0).t();
    double whole = log.duration();
    double right = HeadLogPlot.WIDTH - HeadLogPlot.MARGIN - 60;
    double perSecond = (right - LABELS) / Math.max(whole, 1e-3);
    HeadLogPlot.text(svg, title, HeadLogPlot.MARGIN, top + 14, 15, HeadLogPlot.INK, "start");
    double first = top + 34;
    double bottom = first + (double) ROW * rows.size();
    dark(svg, first - 6, bottom - first + 8, perSecond);
    double step = step(whole);
    for (double t = 0; t <= whole + 1e-9; t += step) {
      double x = LABELS + t * perSecond;
      svg.rectangle(x, first - 6, 1, bottom - first + 8, "#dddddd");
      HeadLogPlot.text(
          svg,
          String.format(Locale.ROOT, "%s s", (float) (t + begin - begin % 1e-3)),
          x,
          bottom + 18,
          12,
          FAINT,
          "middle");
    }
    for (int i = 0; i < rows.size(); i++) {
      DwellSummary.ObjectView view = rows.get(i);
      double y = first + (double) ROW * i;
      HeadLogPlot.text(svg, view.object(), LABELS - 10, y + 12, 12, HeadLogPlot.INK, "end");
      for (Dwell look : looks.all()) {
        if (look.object().equals(view.object())) {
          svg.rectangle(
              LABELS + (look.start() - begin) * perSecond,
              y + 1,
              Math.max(1, look.duration() * perSecond),
              ROW - 5,
              colours.getOrDefault(view.object(), FAINT));
        }
      }
      HeadLogPlot.text(
          svg,
          String.format(Locale.ROOT, "%.1f s", view.seconds()),
          right + 8,
          y + 12,
          12,
          FAINT,
          "start");
    }
  }

  /** Draws the times without a picture, behind the dwells. */
  private void dark(SvgWriter svg, double top, double height, double perSecond) {
    double begin = log.samples().get(0).t();
    int at = 0;
    while (at < log.samples().size()) {
      int from = at;
      while (at < log.samples().size() && !log.samples().get(at).visible()) {
        at++;
      }
      if (at > from) {
        double start = log.samples().get(from).t() - begin;
        double end =
            Math.min(log.duration(), log.samples().get(at - 1).t() - begin + log.shown(at - 1));
        svg.rectangle(
            LABELS + start * perSecond, top, Math.max(1, (end - start) * perSecond), height, DARK);
      }
      at++;
    }
  }

  /**
   * Returns the interval of the tick marks: 1, 2 or 5 times a power of ten, for at most ten marks.
   */
  private static double step(double seconds) {
    double power = Math.pow(10, Math.floor(Math.log10(Math.max(seconds, 1e-3) / 10)));
    for (double factor : new double[] {1, 2, 5}) {
      if (seconds / (power * factor) <= 10) {
        return power * factor;
      }
    }
    return 10 * power;
  }
}
