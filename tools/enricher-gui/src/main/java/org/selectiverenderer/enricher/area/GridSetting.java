package org.selectiverenderer.enricher.area;

import java.util.List;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.text.Texts;

/** The grid that areas snap to, stored in the author's settings. */
public final class GridSetting {
  /** The grid steps that can be chosen, in metres; 0 turns the grid off. */
  public static final List<Double> STEPS = List.of(0.0, 0.01, 0.05, 0.1, 0.25, 0.5, 1.0);

  private static final double USUAL = 0.1;

  private final EnricherSettings settings;

  public GridSetting(EnricherSettings settings) {
    this.settings = settings;
  }

  /** The present grid. */
  public SnapGrid step() {
    String word = settings.word("area.grid", "");
    return STEPS.stream()
        .filter(step -> DecimalFormatter.rounded(step, 2).equals(word))
        .findFirst()
        .map(SnapGrid::new)
        .orElse(new SnapGrid(USUAL));
  }

  /** Sets another step, in metres. */
  public void use(double step) {
    settings.put("area.grid", DecimalFormatter.rounded(step, 2));
  }

  /** Whether areas in the plan snap to walls. */
  public boolean walls() {
    return settings.flag("area.walls", true);
  }

  public void useWalls(boolean snap) {
    settings.put("area.walls", snap);
  }

  /** Formats a step for a menu. */
  public static String title(double step) {
    return step == 0
        ? Texts.of("area.grid.off")
        : Texts.of("area.grid.step", DecimalFormatter.rounded(step, 2));
  }
}
