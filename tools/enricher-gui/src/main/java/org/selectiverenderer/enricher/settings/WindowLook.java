package org.selectiverenderer.enricher.settings;

import java.io.IOException;
import java.nio.file.Path;

/** Gives windows beside the enricher's its theme, text size and language. */
public final class WindowLook {
  private WindowLook() {}

  /**
   * Applies the enricher's settings; on Swing's event thread, before the first component.
   *
   * @param folder folder of the user's settings
   */
  public static void apply(Path folder) {
    EnricherSettings settings = new EnricherSettings(folder);
    try {
      settings.load();
    } catch (IOException e) {
      // The defaults apply; the enricher's window tells of settings that cannot be read.
    }
    Language.of(settings).apply();
    Theme.of(settings.word("theme", "")).apply();
    new FontZoom(settings).apply();
  }
}
