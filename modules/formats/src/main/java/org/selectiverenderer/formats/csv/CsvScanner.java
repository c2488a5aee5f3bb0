package org.selectiverenderer.formats.csv;

import java.util.Arrays;

/**
 * Scans a text for its records and their cells (RFC 4180), with LF, CR or CRLF line ends. Empty
 * lines are skipped, as is white space around a cell, also before a quotation mark.
 */
final class CsvScanner {
  private final String text;
  private final char separator;

  private int at;
  private int line = 1;
  private int start;
  private int startLine = 1;
  private int cells;
  private boolean broken;

  private int from;
  private int to;
  private boolean quoted;

  CsvScanner(String text, CsvDelimiter separator) {
    this.text = text;
    this.separator = separator.character();
  }

  /** Advances to the next record; false after the last one, or at one that is {@link #broken}. */
  boolean next() {
    while (at < text.length() && isEnd(text.charAt(at))) {
      endLine();
    }
    start = at;
    startLine = line;
    cells = 0;
    if (at == text.length()) {
      return false;
    }
    for (at = cell(at); at >= 0; at = cell(at + 1)) {
      line += quoted ? lineEnds(from, to) : 0;
      cells++;
      if (at == text.length() || text.charAt(at) != separator) {
        if (at < text.length()) {
          endLine();
        }
        return true;
      }
    }
    broken = true;
    return false;
  }

  private void endLine() {
    at += text.startsWith("\r\n", at) ? 2 : 1;
    line++;
  }

  private int lineEnds(int begin, int end) {
    int count = 0;
    for (int i = begin; i < end; i++) {
      char c = text.charAt(i);
      count += c == '\n' || c == '\r' && text.charAt(i + 1) != '\n' ? 1 : 0;
    }
    return count;
  }

  private static boolean isEnd(char c) {
    return c == '\n' || c == '\r';
  }

  /** Returns whether the last cell begins with a quotation mark that is never properly closed. */
  boolean broken() {
    return broken;
  }

  /** Returns the character offset at which the record begins. */
  int start() {
    return start;
  }

  /** Returns the line in which the record begins, counted from 1. */
  int startLine() {
    return startLine;
  }

  /** Returns the number of cells of the record. */
  int cells() {
    return cells;
  }

  /** Returns whether the record is the text's last line and has no line end. */
  boolean last() {
    return at == text.length() && line == startLine;
  }

  /**
   * Returns the cells of a record, stripped and without the marks of {@link SpreadsheetText},
   * padded with empty ones to {@code count}.
   */
  String[] cells(int record, int count) {
    String[] found = new String[count];
    int behind = record - 1;
    for (int i = 0; i < count; i++) {
      if (behind >= record && (behind == text.length() || text.charAt(behind) != separator)) {
        Arrays.fill(found, i, count, "");
        return found;
      }
      behind = cell(behind + 1);
      String cell = text.substring(from, to);
      found[i] = SpreadsheetText.plain((quoted ? cell.replace("\"\"", "\"") : cell).strip());
    }
    return found;
  }

  /** Scans a cell; returns the offset after it, or -1 if its quotation mark is not closed. */
  private int cell(int begin) {
    int i = begin;
    while (i < text.length() && Character.isWhitespace(text.charAt(i)) && !isBehind(i)) {
      i++;
    }
    quoted = i < text.length() && text.charAt(i) == '"';
    if (quoted) {
      return quoted(i);
    }
    from = i;
    while (!isBehind(i)) {
      i++;
    }
    to = i;
    return i;
  }

  private int quoted(int open) {
    int close = text.indexOf('"', open + 1);
    while (close >= 0 && text.startsWith("\"", close + 1)) {
      close = text.indexOf('"', close + 2);
    }
    if (close < 0) {
      return -1;
    }
    from = open + 1;
    to = close;
    int i = close + 1;
    while (!isBehind(i)) {
      if (!Character.isWhitespace(text.charAt(i))) {
        return -1;
      }
      i++;
    }
    return i;
  }

  private boolean isBehind(int offset) {
    return offset == text.length()
        || text.charAt(offset) == separator
        || isEnd(text.charAt(offset));
  }

  /** Returns the column, from 1, at which a cell begins in the line where its record begins. */
  int column(int record, int cell) {
    int i = record;
    boolean inQuotes = false;
    for (int before = cell; before > 0 && i < text.length() && !isEnd(text.charAt(i)); i++) {
      char c = text.charAt(i);
      if (c == '"') {
        inQuotes = !inQuotes;
      } else if (c == separator && !inQuotes) {
        before--;
      }
    }
    return i - record + 1;
  }

  /** Returns the column, from 1, of the last quotation mark left open in that line. */
  int openQuote(int record) {
    int open = -1;
    for (int i = record; i < text.length() && !isEnd(text.charAt(i)); i++) {
      if (text.charAt(i) == '"') {
        open = open < 0 ? i : -1;
      }
    }
    return Math.max(record, open) - record + 1;
  }
}
