package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import java.util.Locale;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Reports the errors of one JSON file, each with the consequence for the file.
 *
 * @param outcome the consequence of an error, such as {@code the study is not used}
 */
record JsonErrorReporter(String file, String outcome, ProblemCollector problems) {
  void at(SourceLocation at, String message) {
    boolean question = message.endsWith("?");
    String first = outcome.substring(0, 1);
    problems.error(
        at,
        message
            + (question ? " " : "; ")
            + (question ? first.toUpperCase(Locale.ROOT) : first)
            + outcome.substring(1));
  }

  void noJson(JsonProcessingException e) {
    at(place(e.getLocation()), "this is not valid JSON: " + sentence(e));
  }

  SourceLocation place(JsonLocation at) {
    return place(file, at);
  }

  /** Returns a parser location as line and column in characters. */
  static SourceLocation place(String file, JsonLocation at) {
    return at == null
        ? new SourceLocation(file, 1, 1)
        : new SourceLocation(file, Math.max(1, at.getLineNr()), Math.max(1, at.getColumnNr()));
  }

  /** Returns the parser's message without the locations in it, which refer to its buffer. */
  static String sentence(JsonProcessingException e) {
    return e.getOriginalMessage()
        .lines()
        .findFirst()
        .orElse("")
        .replaceFirst("\\s*\\(start marker at.*", "")
        .replaceFirst("\\s*\\(not recognized as one since.*", "")
        .replaceFirst("\\s*at \\[Source:.*", "");
  }
}
