package org.selectiverenderer.study.rehearsal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.chart.ChartColour;
import org.selectiverenderer.chart.SizedFont;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.study.session.StudyPlan;

/**
 * The picture of a plan: a row for each place, a column for each trial, coloured by the combination
 * of levels, block after block. Trials of one combination have the same colour everywhere.
 */
final class PlanPicture {
  /** Number of rows that are drawn; more are not legible. */
  static final int MOST_PLACES = 100;

  /** Number of trials of a block that are drawn. */
  private static final int MOST_TRIALS = 400;

  private static final int LEFT = 190;
  private static final int TOP = 44;
  private static final int ROW = 18;
  private static final int WIDE = 640;
  private static final int GAP = 14;
  private static final List<ChartColour> COLOURS =
      List.of(
          ChartColour.BLUE,
          ChartColour.ORANGE,
          ChartColour.GREEN,
          ChartColour.VERMILION,
          ChartColour.SKY,
          ChartColour.PURPLE,
          ChartColour.GREY,
          ChartColour.INK,
          ChartColour.GRID);

  private final StudyPlan plan;
  private final List<StudyPlan.Place> rows;
  private final List<String> combinations = new ArrayList<>();
  private final SizedFont plain;
  private final SizedFont bold;

  PlanPicture(StudyPlan plan) {
    this.plan = plan;
    rows = plan.places().subList(0, Math.min(MOST_PLACES, plan.places().size()));
    FontLibrary fonts = new FontLibrary();
    plain = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), 11, false);
    bold = new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), 12, true);
    for (StudyPlan.Place place : rows) {
      for (StudyPlan.Block block : place.blocks()) {
        for (StudyPlan.PlannedTrial trial : block.trials()) {
          // Trials without levels, such as those of a practice block, stay grey.
          if (!trial.levels().isEmpty()
              && !combinations.contains(trial.combination())
              && combinations.size() < 2 * COLOURS.size()) {
            combinations.add(trial.combination());
          }
        }
      }
    }
  }

  /** Returns the picture as an SVG element. */
  String svg() {
    List<StudyPlan.Block> blocks = rows.get(0).blocks();
    boolean coloured = combinations.size() <= COLOURS.size();
    int legend = coloured ? combinations.size() : 1;
    int width = LEFT + WIDE + GAP * Math.max(1, blocks.size()) + 10;
    int height = TOP + ROW * rows.size() + 14 + ROW * legend + 10;
    SvgCanvas canvas = SvgCanvas.inline(width, height, "Plan of " + plan.study().name());
    canvas.rectangle(0, 0, width, height, ChartColour.PAPER);
    for (int row = 0; row < rows.size(); row++) {
      label(canvas, rows.get(row), TOP + row * ROW + 13);
    }
    double left = LEFT;
    double each = (double) WIDE / Math.max(1, blocks.size());
    for (int block = 0; block < blocks.size(); block++) {
      canvas.text(bold.fit(blocks.get(block).name(), each), left, 18, bold, ChartColour.INK);
      for (int row = 0; row < rows.size(); row++) {
        draw(canvas, rows.get(row).blocks().get(block), left, TOP + row * ROW, each, coloured);
      }
      canvas.text("first trial to last", left, 36, plain, ChartColour.FAINT_INK);
      left += each + GAP;
    }
    int at = TOP + ROW * rows.size() + 14;
    if (!coloured) {
      canvas.text(
          "more combinations than colours: experiment plan --format csv lists them",
          LEFT,
          at + 12,
          plain,
          ChartColour.FAINT_INK);
      return canvas.finish();
    }
    for (int one = 0; one < combinations.size(); one++) {
      canvas.rectangle(LEFT, at + one * ROW, 14, 14, COLOURS.get(one));
      canvas.text(
          plain.fit(combinations.get(one), WIDE),
          LEFT + 20,
          at + one * ROW + 11,
          plain,
          ChartColour.INK);
    }
    return canvas.finish();
  }

  private void label(SvgCanvas canvas, StudyPlan.Place place, int y) {
    boolean next = place.number() == plan.next();
    String text =
        String.format(
            Locale.ROOT,
            "%d %s %s",
            place.number(),
            place.participant().orElse(next ? "next" : ""),
            place.group().name());
    SizedFont font = next ? bold : plain;
    canvas.text(font.fit(text, LEFT - 16), 6, y, font, ChartColour.INK);
  }

  private void draw(
      SvgCanvas canvas,
      StudyPlan.Block block,
      double left,
      double top,
      double width,
      boolean coloured) {
    int trials = Math.min(MOST_TRIALS, block.trials().size());
    if (trials == 0) {
      canvas.text(
          plain.fit(block.open().orElse("no order"), width),
          left,
          top + 13,
          plain,
          ChartColour.FAINT_INK);
      return;
    }
    double each = width / trials;
    for (int trial = 0; trial < trials; trial++) {
      int combination = combinations.indexOf(block.trials().get(trial).combination());
      canvas.rectangle(
          left + trial * each,
          top,
          Math.max(0.3, each > 4 ? each - 1 : each),
          ROW - 2,
          coloured && combination >= 0 ? COLOURS.get(combination) : ChartColour.GREY);
    }
  }
}
