package org.selectiverenderer.enricher.settings;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Font;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/** The text size of the window, to which sizes given in letters adapt. */
public final class FontZoom {
  /** The default, in percent of the system's text size. */
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

  /** The stored text size in percent. */
  public int percent() {
    return Math.max(LEAST, Math.min(MOST, settings.number(KEY, USUAL)));
  }

  /** Makes the text larger or smaller by some steps; returns the new percentage. */
  public int change(int steps) {
    return set(percent() + steps * STEP);
  }

  /** Resets the text to the system's size. */
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

  /** Sets the default font of the look and feel; needed again after each change of the theme. */
  public void apply() {
    @Nullable Font usual = UIManager.getLookAndFeelDefaults().getFont(FONT);
    boolean asUsual = percent() == USUAL || usual == null;
    UIManager.put(
        FONT, asUsual ? null : usual.deriveFont(usual.getSize2D() * percent() / (float) USUAL));
  }
}
