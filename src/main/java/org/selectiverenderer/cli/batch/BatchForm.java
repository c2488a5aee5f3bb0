package org.selectiverenderer.cli.batch;

/**
 * The format in which the texts of many files are joined into one output.
 *
 * @param begin printed before the first text
 * @param between printed between two texts
 * @param end printed after the last text; if it is not empty, each text loses its trailing line
 *     feed
 */
public record BatchForm(String begin, String between, String end) {
  /** Lines that name their own file. */
  public static final BatchForm LINES = new BatchForm("", "", "");

  /** Texts with an empty line between them. */
  public static final BatchForm TEXTS = new BatchForm("", "\n", "");

  /** JSON values, as one array. */
  public static final BatchForm JSON_ARRAY = new BatchForm("[\n", ",\n", "\n]\n");

  /** Creates the format of a table with one header row. */
  public static BatchForm table(String header) {
    return new BatchForm(header, "", "");
  }

  /** Returns the output when there is no text at all. */
  String ofNone() {
    return end.isEmpty() ? "" : begin + end.stripLeading();
  }

  /** Returns a text as it is printed among the others. */
  String trimmed(String text) {
    return end.isEmpty() ? text : text.stripTrailing();
  }
}
