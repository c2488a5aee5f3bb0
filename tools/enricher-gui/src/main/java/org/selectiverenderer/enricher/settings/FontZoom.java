package org.selectiverenderer.enricher.settings;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Font;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/** How large the window's letters are, and with them all that is measured by letters. */
public final class FontZoom {
  /** In percent of the system's letters. */
  public static final int USUAL = 100;

  private static final int LEAST = 70;
  private static final int MOST = 220;
  private static final int STEP = 10;
  private static final String FONT = "defaultFont";
  private static final String KEY = "zoom";

  private final EnricherSettings settings;

  public FontZoom(EnricherSettings settings) {
    this.settings = settings;
  }

  /** In percent, as remembered. */
  public int percent() {
    return Math.max(LEAST, Math.min(MOST, settings.number(KEY, USUAL)));
  }

  /** Makes the letters larger or smaller by a step. */
  public int change(int steps) {
    return set(percent() + steps * STEP);
  }

  /** As large as the system's. */
  public int reset() {
    return set(USUAL);
  }

  private int set(int percent) {
    settings.put(KEY, percent);
    settings.put(KEY, percent());
    apply();
    FlatLaf.updateUI();
    return percent();
  }

  /** Gives what is made from now on these letters; after each change of the colours. */
  public void apply() {
    @Nullable Font usual = UIManager.getLookAndFeelDefaults().getFont(FONT);
    boolean asUsual = percent() == USUAL || usual == null;
    UIManager.put(
        FONT, asUsual ? null : usual.deriveFont(usual.getSize2D() * percent() / (float) USUAL));
  }
}
