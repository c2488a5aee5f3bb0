package org.selectiverenderer.x3d.script;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Explains errors at constructs of ECMAScript that the script engine does not have. */
public final class UnsupportedSyntax {
  /** A construct, recognised by what stands in the line, and what to write in its place. */
  private record Construct(Pattern pattern, String name, String instead) {}

  private static final List<Construct> CONSTRUCTS =
      List.of(
          construct("\\bclass\\b", "class", "write a function and add methods to its prototype"),
          construct(
              "\\basync(?:\\s+[\\w$]+|\\s*\\([^)]*\\)\\s*=>)|\\bawait\\b",
              "async and await",
              "use Promise and then()"),
          construct(
              "\\bimport\\b|\\bexport\\b",
              "import and export",
              "put all functions into the program of one Script"),
          construct(
              "\\bnew\\s*\\.\\s*target\\b", "new.target", "test this instanceof the function"),
          construct(
              "\\.\\.\\.\\s*[\\w$]+\\s*\\)\\s*=>",
              "the rest parameter (...) of an arrow function",
              "write function (...) { }"),
          construct(
              "\\.\\.\\.\\s*[\\w$]+\\s*[}\\]]\\s*=(?!=)",
              "rest (...) in destructuring",
              "use slice() for arrays and copy the properties of objects"));

  /** Characters of a line that are looked at, on each side of the error. */
  private static final int AROUND = 200;

  private UnsupportedSyntax() {}

  private static Construct construct(String pattern, String name, String instead) {
    return new Construct(Pattern.compile(pattern), name, instead);
  }

  /**
   * Returns a sentence that names the unsupported construct and what to write in its place; the
   * parser's own message when there is none near the error.
   *
   * @param message the parser's message
   * @param line the line of the error
   * @param column the column that the parser has come to, from 0
   */
  public static String explained(String message, String line, int column) {
    int from = Math.max(0, Math.min(line.length(), column) - AROUND);
    int to = Math.min(line.length(), Math.max(0, column) + AROUND);
    String near = line.substring(from, to);
    Construct nearest = null;
    int at = -1;
    for (Construct construct : CONSTRUCTS) {
      Matcher found = construct.pattern.matcher(near);
      while (found.find()) {
        boolean reached = from + found.start() <= column;
        boolean touches = from + found.end() >= column - 2 || construct.name.contains("(...)");
        if (reached && touches && found.start() > at
            || !reached && nearest == null && construct.name.contains("(...)")) {
          nearest = construct;
          at = found.start();
        }
      }
    }
    return nearest == null
        ? message
        : "%s, at column %s, is not supported; %s"
            .formatted(nearest.name, from + at + 1, nearest.instead);
  }
}
