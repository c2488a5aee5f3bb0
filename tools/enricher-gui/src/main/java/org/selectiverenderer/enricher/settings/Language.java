package org.selectiverenderer.enricher.settings;

import java.util.Locale;
import org.selectiverenderer.enricher.text.ToolkitTexts;

/** The language of the user interface. */
public enum Language {
  /** The system's display language, if it is one of these; else English. */
  SYSTEM("", "As the System"),
  ENGLISH("en", "English"),
  GREEK("el", "\u0395\u03bb\u03bb\u03b7\u03bd\u03b9\u03ba\u03ac");

  private static final String KEY = "language";

  private final String tag;
  private final String title;

  Language(String tag, String title) {
    this.tag = tag;
    this.title = title;
  }

  /** The language's name in the language itself. */
  public String title() {
    return title;
  }

  /** The language in the settings. */
  public static Language of(EnricherSettings settings) {
    String word = settings.word(KEY, "");
    for (Language language : values()) {
      if (language.tag.equals(word)) {
        return language;
      }
    }
    return SYSTEM;
  }

  /** Stores this language for the next start. */
  public void choose(EnricherSettings settings) {
    settings.put(KEY, tag);
  }

  /**
   * Sets the display locale, which Swing's own dialogs follow, too; called before the first
   * component is created.
   */
  public void apply() {
    if (this != SYSTEM) {
      Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag(tag));
    }
    ToolkitTexts.install();
  }
}
