package org.selectiverenderer.enricher.settings;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Toolkit;
import java.util.Locale;

/** The colours of the window. */
public enum Theme {
  /** Those of the desktop, where it tells; light elsewhere. */
  SYSTEM("menu.systemcolours"),
  LIGHT("menu.lightcolours"),
  DARK("menu.darkcolours");

  private final String text;

  Theme(String text) {
    this.text = text;
  }

  /** The name of the text that a menu shows. */
  public String text() {
    return text;
  }

  public static Theme of(String word) {
    for (Theme theme : values()) {
      if (theme.name().equalsIgnoreCase(word)) {
        return theme;
      }
    }
    return SYSTEM;
  }

  /** Gives all windows these colours. */
  public void apply() {
    boolean dark = this == DARK || this == SYSTEM && systemIsDark();
    FlatLaf.setup(dark ? new FlatDarkLaf() : new FlatLightLaf());
    FlatLaf.updateUI();
  }

  private static boolean systemIsDark() {
    // GNOME and its relatives say it in the name of their theme; others do not tell Java.
    Object theme = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
    return theme != null && theme.toString().toLowerCase(Locale.ROOT).contains("dark");
  }
}
