package org.selectiverenderer.enricher.area;

import java.util.List;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.document.area.GridStep;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.text.Texts;

/** The grid that areas snap to, as the author's settings remember it. */
public final class GridSetting {
  /** What can be chosen, in the scene's unit; 0 is none. */
  public static final List<Double> STEPS = List.of(0.0, 0.01, 0.05, 0.1, 0.25, 0.5, 1.0);

  private static final double USUAL = 0.1;

  private final EnricherSettings settings;

  public GridSetting(EnricherSettings settings) {
    this.settings = settings;
  }

  /** The grid now. */
  public GridStep step() {
    String word = settings.word("area.grid", "");
    return STEPS.stream()
        .filter(step -> DecimalText.rounded(step, 2).equals(word))
        .findFirst()
        .map(GridStep::new)
        .orElse(new GridStep(USUAL));
  }

  /** Another one from now on. */
  public void use(double step) {
    settings.put("area.grid", DecimalText.rounded(step, 2));
  }

  /** Whether the plan snaps to walls. */
  public boolean walls() {
    return settings.flag("area.walls", true);
  }

  public void useWalls(boolean snap) {
    settings.put("area.walls", snap);
  }

  /** A step as a menu shows it. */
  public static String title(double step) {
    return step == 0
        ? Texts.of("area.grid.off")
        : Texts.of("area.grid.step", DecimalText.rounded(step, 2));
  }
}
