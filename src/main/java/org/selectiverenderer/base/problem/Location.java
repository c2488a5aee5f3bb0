package org.selectiverenderer.base.problem;

/**
 * A place in a file, for messages.
 *
 * @param file as the user named it, or as an Inline's url resolved
 * @param line from 1; 0 when the place is the file as a whole
 * @param column from 1, in characters; 0 when unknown
 */
public record Location(String file, int line, int column) {
  /** The file as a whole. */
  public static Location of(String file) {
    return new Location(file, 0, 0);
  }

  /** {@code file:line:column}, shorter when line or column are unknown. */
  @Override
  public String toString() {
    if (line == 0) {
      return file;
    }
    return column == 0 ? file + ":" + line : file + ":" + line + ":" + column;
  }
}
