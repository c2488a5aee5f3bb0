package org.selectiverenderer.enricher;

import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.FontZoom;
import org.selectiverenderer.enricher.settings.Language;
import org.selectiverenderer.enricher.settings.Theme;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * How the window looks, as the user's settings have it. For the event dispatch thread.
 *
 * @param access what scenes may name besides their own files
 * @param complaint what is to be said of reading the settings; empty for nothing
 */
record WindowLook(EnricherSettings settings, ContentAccess access, String complaint) {

  /**
   * Reads the settings and applies them: colours come before the first component is made.
   *
   * @param folder of the user's settings
   * @param given what scenes may name beside what the settings allow
   */
  static WindowLook remembered(Path folder, ContentAccess given) {
    EnricherSettings settings = new EnricherSettings(folder);
    String complaint = "";
    ContentAccess access = given;
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
    return new WindowLook(settings, access, complaint);
  }

  void use(Theme theme) {
    settings.put("theme", theme.name());
    theme.apply();
    new FontZoom(settings).apply();
  }

  /**
   * Makes all letters larger or smaller.
   *
   * @param steps above 0 for larger, below for smaller, 0 for as the system has them
   * @return what is to be said of it
   */
  String zoom(int steps) {
    FontZoom zoom = new FontZoom(settings);
    int percent = steps == 0 ? zoom.reset() : zoom.change(steps);
    return Texts.of("window.zoom", DecimalText.grouped(percent));
  }

  /**
   * Remembers the language for the next start.
   *
   * @return what is to be said of it
   */
  String use(Language language) {
    language.choose(settings);
    return Texts.of("window.language", language.title());
  }
}
