package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.FontZoom;
import org.selectiverenderer.enricher.settings.Language;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Applies theme, text size and language of the user's settings to the window. For the event
 * dispatch thread.
 *
 * @param access folders and hosts that scenes may read from
 * @param complaint why the settings could not be read; empty if they were
 */
record AppearanceSettings(EnricherSettings settings, ContentAccessPolicy access, String complaint) {

  /**
   * Reads the settings and applies them, as the theme must be set before the first component is
   * made.
   *
   * @param folder of the user's settings
   * @param given folders and hosts that scenes may read from, in addition to those of the settings
   */
  static AppearanceSettings remembered(Path folder, ContentAccessPolicy given) {
    EnricherSettings settings = new EnricherSettings(folder);
    String complaint = "";
    ContentAccessPolicy access = given;
    try {
      settings.load();
      access = settings.access().and(given);
    } catch (IOException | IllegalArgumentException e) {
      complaint = String.valueOf(e.getMessage());
    }
    Language.of(settings).apply();
    Theme.of(settings.word("theme", "")).apply();
    FontZoom zoom = new FontZoom(settings);
    if (zoom.percent() != FontZoom.USUAL) {
      zoom.apply();
    }
    return new AppearanceSettings(settings, access, complaint);
  }

  void use(Theme theme) {
    settings.put("theme", theme.name());
    theme.apply();
    new FontZoom(settings).apply();
  }

  /**
   * Makes all text larger or smaller.
   *
   * @param steps above 0 for larger, below 0 for smaller, 0 for the system's size
   * @return a message for the status bar
   */
  String zoom(int steps) {
    FontZoom zoom = new FontZoom(settings);
    int percent = steps == 0 ? zoom.reset() : zoom.change(steps);
    return Texts.of("window.zoom", DecimalFormatter.grouped(percent));
  }

  /**
   * Remembers the language for the next start.
   *
   * @return a message for the status bar
   */
  String use(Language language) {
    language.choose(settings);
    return Texts.of("window.language", language.title());
  }
}
