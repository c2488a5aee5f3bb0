package org.selectiverenderer.enricher.source;

import org.selectiverenderer.x3d.source.TextChange;

/**
 * A page of text as a text component holds it: line ends are single line feeds there, whatever they
 * are in the file, and lone carriage returns count as line ends too.
 */
record ShownText(String file, String shown) {
  static ShownText of(String file) {
    return new ShownText(file, file.replace("\r\n", "\n").replace('\r', '\n'));
  }

  /** The offset in the file's text of one in the shown text. */
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

  /** The offset in the shown text of one in the file's text. */
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
   * The change of the file's text that what is shown now means: between what is alike before and
   * behind, with the file's line ends.
   */
  TextChange change(String now) {
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
    return new TextChange(
        inFile(start),
        inFile(shown.length() - same),
        windows ? typed.replace("\n", "\r\n") : typed);
  }
}
