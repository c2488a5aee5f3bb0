package org.selectiverenderer.enricher.source;

import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A part of the file's text with its line ends normalized to line feeds, as a text component holds
 * it, and the mapping of offsets between both. Lone carriage returns count as line ends too.
 */
record NormalizedText(String file, String shown) {
  static NormalizedText of(String file) {
    return new NormalizedText(file, file.replace("\r\n", "\n").replace('\r', '\n'));
  }

  /** Converts an offset in the shown text to one in the file's text. */
  int inFile(int offset) {
    if (file.length() == shown.length()) {
      return Math.min(offset, file.length());
    }
    int at = 0;
    for (int i = 0; i < offset && at < file.length(); i++) {
      at += file.startsWith("\r\n", at) ? 2 : 1;
    }
    return at;
  }

  /** Converts an offset in the file's text to one in the shown text. */
  int inShown(int offset) {
    if (file.length() == shown.length()) {
      return Math.min(offset, shown.length());
    }
    int at = 0;
    int i = 0;
    while (i < offset && i < file.length()) {
      i += file.startsWith("\r\n", i) ? 2 : 1;
      at++;
    }
    return at;
  }

  /**
   * Returns the change of the file's text that makes it correspond to a new shown text: the range
   * between common prefix and suffix, with the file's line ends.
   */
  TextEdit change(String now) {
    int most = Math.min(shown.length(), now.length());
    int start = 0;
    while (start < most && shown.charAt(start) == now.charAt(start)) {
      start++;
    }
    int same = 0;
    while (same < most - start
        && shown.charAt(shown.length() - 1 - same) == now.charAt(now.length() - 1 - same)) {
      same++;
    }
    String typed = now.substring(start, now.length() - same);
    boolean windows = file.contains("\r\n");
    return new TextEdit(
        inFile(start),
        inFile(shown.length() - same),
        windows ? typed.replace("\n", "\r\n") : typed);
  }
}
