package org.selectiverenderer.enricher.text;

import java.util.Optional;

/**
 * Translates what the document's code says about an edit or an object into the language of the
 * window: why something is refused, what is left as it is. It says so in English, as the command
 * line does; the bundle {@code remarks} has these sentences as patterns, and their translations. A
 * sentence that matches none is shown as it is.
 */
public final class Remarks {
  private static final String PLACE = ": ";

  private static final SentencePatterns PATTERNS = new SentencePatterns("remarks");

  private Remarks() {}

  /**
   * Returns a sentence in the language of the window.
   *
   * @param sentence may have a place before it, such as a file with line and column and a colon
   */
  public static String shown(String sentence) {
    Optional<String> whole = PATTERNS.shown(sentence);
    for (int at = sentence.indexOf(PLACE);
        whole.isEmpty() && at >= 0;
        at = sentence.indexOf(PLACE, at + 1)) {
      String place = sentence.substring(0, at + PLACE.length());
      whole = PATTERNS.shown(sentence.substring(place.length())).map(shown -> place + shown);
    }
    return whole.orElse(sentence);
  }

  /** Returns what a failure says, in the language of the window. */
  public static String of(Exception failure) {
    return shown(String.valueOf(failure.getMessage()));
  }
}
