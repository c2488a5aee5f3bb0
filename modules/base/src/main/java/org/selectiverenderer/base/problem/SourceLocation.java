package org.selectiverenderer.base.problem;

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

  /** Returns {@code file:line:column}, without line or column if they are unknown. */
  @Override
  public String toString() {
    if (line == 0) {
      return file;
    }
    return column == 0 ? file + ":" + line : file + ":" + line + ":" + column;
  }
}
