package org.selectiverenderer.x3d.write;

import java.util.Locale;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/** The characters that an encoding can hold in strings; others are told and replaced. */
final class CharacterRules {
  private static final char REPLACEMENT = '\ufffd';

  private final SceneFormat format;
  private final ProblemCollector problems;

  CharacterRules(SceneFormat format, ProblemCollector problems) {
    this.format = format;
    this.problems = problems;
  }

  /**
   * Returns a string with U+FFFD for what the encoding cannot hold, and a line feed for a carriage
   * return.
   *
   * @param at finds the place of the string, if something is told
   * @param code whether it is written as the content of an element, not as a value
   */
  String written(String text, Supplier<SourceLocation> at, boolean code) {
    int bad = 0;
    while (bad < text.length() && holds(text, bad, code)) {
      bad++;
    }
    if (bad == text.length()) {
      return text;
    }
    char first = text.charAt(bad);
    StringBuilder written = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      boolean pair = c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
      if (holds(text, i, code)) {
        written.append(c);
      } else if (!pair) {
        written.append(c == '\r' ? '\n' : REPLACEMENT);
      }
    }
    problems.warning(
        at.get(),
        String.format(
            Locale.ROOT,
            "%s cannot hold the character U+%04X here; %s is written instead",
            format.title(),
            (int) first,
            first == '\r' ? "a line feed" : "U+FFFD"));
    return written.toString();
  }

  /** Returns a comment with LF line ends, as {@link #written} does. */
  String comment(String text, Supplier<SourceLocation> at) {
    return written(text.replace("\r\n", "\n").replace('\r', '\n'), at, false);
  }

  private boolean holds(String text, int at, boolean code) {
    char c = text.charAt(at);
    if (Character.isSurrogate(c)) {
      return Character.isHighSurrogate(c)
          ? at + 1 < text.length() && Character.isLowSurrogate(text.charAt(at + 1))
          : at > 0 && Character.isHighSurrogate(text.charAt(at - 1));
    }
    return switch (format) {
      case JSON -> true;
      case CLASSIC -> c != '\r';
      case XML -> c >= ' ' ? c < '\ufffe' : c == '\n' || c == '\t' || c == '\r' && !code;
    };
  }
}
