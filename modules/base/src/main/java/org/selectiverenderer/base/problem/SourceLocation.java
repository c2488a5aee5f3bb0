package org.selectiverenderer.base.problem;

import org.selectiverenderer.base.markup.ControlCharacterEscaper;

/**
 * A location in a file (file, line, column), for messages.
 *
 * @param file the file as the user named it, or the resolved url of an Inline
 * @param line from 1; 0 for the file as a whole
 * @param column from 1, in characters; 0 if unknown
 */
public record SourceLocation(String file, int line, int column) {
  /** Returns the location of a file as a whole. */
  public static SourceLocation of(String file) {
    return new SourceLocation(file, 0, 0);
  }

  /**
   * Returns {@code file:line:column}, without line or column if they are unknown. Control
   * characters of the file's name are escaped, so that it is one line.
   */
  @Override
  public String toString() {
    String shown = ControlCharacterEscaper.line(file);
    if (line == 0) {
      return shown;
    }
    return column == 0 ? shown + ":" + line : shown + ":" + line + ":" + column;
  }
}
