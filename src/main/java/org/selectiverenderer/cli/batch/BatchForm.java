package org.selectiverenderer.cli.batch;

/**
 * How the texts of many files become one output.
 *
 * @param begin before the first one
 * @param between two of them
 * @param end after the last one; where there is one, each text loses its own last line end
 */
public record BatchForm(String begin, String between, String end) {
  /** Lines that say themselves which file they are about. */
  public static final BatchForm LINES = new BatchForm("", "", "");

  /** Texts with an empty line between them. */
  public static final BatchForm TEXTS = new BatchForm("", "\n", "");

  /** JSON values, as one array. */
  public static final BatchForm JSON_ARRAY = new BatchForm("[\n", ",\n", "\n]\n");

  /** Rows of a table. */
  public static BatchForm table(String header) {
    return new BatchForm(header, "", "");
  }

  /** The output when there is no text at all. */
  String ofNone() {
    return end.isEmpty() ? "" : begin + end.stripLeading();
  }

  /** A text as it stands among the others. */
  String trimmed(String text) {
    return end.isEmpty() ? text : text.stripTrailing();
  }
}
