package org.selectiverenderer.render.glsl;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The first error in a shader compiler's log.
 *
 * @param line the line from 1; 0 if the log does not tell
 * @param column the column from 1; 0 if the log does not tell
 */
public record CompilerLog(int line, int column, String message) {
  // Mesa, which counts columns from 0: 0:12(5): error: ...; NVIDIA: 0(12) : error C1008: ...;
  // others: ERROR: 0:12: ...
  private static final Pattern PLACE =
      Pattern.compile(
          "(?:(?:ERROR|error):\\s*)?\\d+(?::(\\d+)|\\((\\d+)\\))(?:\\((\\d+)\\))?\\s*:"
              + "\\s*(?:(?:preprocessor )?error\\s*\\w*\\s*:?)?\\s*(.*)");

  private static final int LONGEST = 200;

  /** Parses a log; the first line with a position that is no warning counts. */
  public static CompilerLog of(String log) {
    for (String line : log.lines().toList()) {
      Matcher place = PLACE.matcher(line.strip());
      if (place.matches() && !line.contains("warning")) {
        String number = place.group(1) == null ? place.group(2) : place.group(1);
        return new CompilerLog(
            number(number),
            place.group(3) == null ? 0 : 1 + number(place.group(3)),
            words(place.group(4)));
      }
    }
    return new CompilerLog(
        0, 0, words(log.lines().filter(l -> !l.isBlank()).findFirst().orElse("")));
  }

  private static int number(String digits) {
    return digits.length() > 8 ? 0 : Integer.parseInt(digits);
  }

  /** Returns a message as a part of a sentence, with the author's names. */
  private static String words(String text) {
    String plain =
        text.strip()
            .replaceFirst("^(?i)error:\\s*", "")
            .replaceAll("\\b" + BuiltInDeclarations.NEW + "(?=[A-Z])", BuiltInDeclarations.OLD)
            .replaceFirst("[.;]+$", "");
    return plain.length() <= LONGEST ? plain : plain.substring(0, LONGEST) + "…";
  }
}
