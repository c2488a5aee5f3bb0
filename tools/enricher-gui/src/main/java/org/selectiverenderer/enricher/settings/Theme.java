package org.selectiverenderer.enricher.settings;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Toolkit;
import java.util.Locale;
import org.selectiverenderer.base.natives.FlatLafLibrary;

/** The colour theme of the window. */
public enum Theme {
  /** The theme of the desktop, where it is known; else light. */
  SYSTEM("menu.systemcolours"),
  LIGHT("menu.lightcolours"),
  DARK("menu.darkcolours");

  private final String text;

  Theme(String text) {
    this.text = text;
  }

  /** The bundle key of the menu text. */
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

  /** Applies the theme to all windows. */
  public void apply() {
    boolean dark = this == DARK || this == SYSTEM && systemIsDark();
    FlatLafLibrary.use(Theme.class);
    FlatLaf.setup(dark ? new FlatDarkLaf() : new FlatLightLaf());
    FlatLaf.updateUI();
  }

  private static boolean systemIsDark() {
    // GNOME-based desktops have it in the name of their theme; Java cannot ask others.
    Object theme = Toolkit.getDefaultToolkit().getDesktopProperty("gnome.Net/ThemeName");
    return theme != null && theme.toString().toLowerCase(Locale.ROOT).contains("dark");
  }
}
