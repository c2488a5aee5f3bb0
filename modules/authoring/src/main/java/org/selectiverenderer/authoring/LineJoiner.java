package org.selectiverenderer.authoring;

import java.util.List;

/**
 * Joins lines of XML into text for a line on which other elements stand. It removes line breaks
 * between elements, with the indentation, and keeps those within a tag, a program, a comment or
 * other text, since they keep numbers apart and end the comments of programs.
 */
final class LineJoiner {
  private static final String CDATA = "<![CDATA[";
  private static final String COMMENT = "<!--";

  private final StringBuilder joined = new StringBuilder();

  /** Holds what ends the construct that is open at the end of the text so far; empty if none is. */
  private String end = "";

  private LineJoiner() {}

  static String join(List<String> lines) {
    LineJoiner joiner = new LineJoiner();
    lines.forEach(joiner::add);
    return joiner.joined.toString();
  }

  private void add(String line) {
    String text = end.isEmpty() ? line.strip() : line;
    boolean between =
        end.isEmpty() && endsWithElement() && (text.isEmpty() || text.startsWith("<"));
    if (!between) {
      joined.append('\n');
    }
    joined.append(text);
    scan(text);
  }

  private boolean endsWithElement() {
    return joined.length() == 0 || joined.charAt(joined.length() - 1) == '>';
  }

  private void scan(String text) {
    int at = 0;
    while (at < text.length()) {
      if (!end.isEmpty()) {
        at = inside(text, at);
      } else if (text.startsWith(CDATA, at)) {
        end = "]]>";
        at += CDATA.length();
      } else if (text.startsWith(COMMENT, at)) {
        end = "-->";
        at += COMMENT.length();
      } else {
        end = text.charAt(at) == '<' ? ">" : "";
        at++;
      }
    }
  }

  /** Scans what is open; returns where to go on. */
  private int inside(String text, int at) {
    char next = text.charAt(at);
    if (end.equals(">") && (next == '\'' || next == '"')) {
      end = String.valueOf(next); // a value, in which the tag does not end
      return at + 1;
    }
    if (!text.startsWith(end, at)) {
      return at + 1;
    }
    int after = at + end.length();
    end = end.equals("'") || end.equals("\"") ? ">" : "";
    return after;
  }
}
