package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;

/** Wraps text into lines at word boundaries. */
final class LineWrapper {
  /** The width of a page of text, in characters. */
  static final int WIDTH = 120;

  private LineWrapper() {}

  /** Returns lines of at most that many characters; a longer word has a line of its own. */
  static List<String> of(String text, int width) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.split(" ")) {
      if (!line.isEmpty() && line.length() + 1 + word.length() > width) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    lines.add(line.toString());
    return lines;
  }

  /**
   * Appends a text in terminated lines of the page's width.
   *
   * @param first prefix of the first line
   * @param others prefix of the other lines, as long as {@code first}
   */
  static void write(StringBuilder out, String first, String others, String text) {
    String before = first;
    for (String line : of(text, WIDTH - first.length())) {
      out.append(before).append(line).append('\n');
      before = others;
    }
  }
}
