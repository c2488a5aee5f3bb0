package org.selectiverenderer.authoring.file;

import java.util.ArrayList;
import java.util.List;

/** Splits a text into lines. */
final class LineTokenizer {
  private LineTokenizer() {}

  /** Returns the lines with their line ends; the last line may have none. */
  static List<String> of(String text) {
    List<String> lines = new ArrayList<>();
    for (int from = 0; from < text.length(); ) {
      int end = text.indexOf('\n', from);
      end = end < 0 ? text.length() : end + 1;
      lines.add(text.substring(from, end));
      from = end;
    }
    return lines;
  }
}
