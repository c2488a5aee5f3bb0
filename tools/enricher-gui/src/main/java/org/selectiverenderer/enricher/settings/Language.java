package org.selectiverenderer.enricher.settings;

import java.util.Locale;

/** The language of the window. */
public enum Language {
  /** That of the system's display, where it is one of these; English elsewhere. */
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

  /** What the language calls itself, as those look for it who speak it. */
  public String title() {
    return title;
  }

  /** The one that the settings name. */
  public static Language of(EnricherSettings settings) {
    String word = settings.word(KEY, "");
    for (Language language : values()) {
      if (language.tag.equals(word)) {
        return language;
      }
    }
    return SYSTEM;
  }

  /** Remembers this one for the next start. */
  public void choose(EnricherSettings settings) {
    settings.put(KEY, tag);
  }

  /** Makes this one the display's, before the first component is made. */
  public void apply() {
    if (this != SYSTEM) {
      Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag(tag));
    }
  }
}
