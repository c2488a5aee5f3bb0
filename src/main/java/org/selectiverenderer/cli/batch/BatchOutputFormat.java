package org.selectiverenderer.cli.batch;

/**
 * The format in which the texts of many files are joined into one output.
 *
 * @param begin printed before the first text
 * @param between printed between two texts
 * @param end printed after the last text; if it is not empty, each text loses its trailing line
 *     feed
 */
public record BatchOutputFormat(String begin, String between, String end) {
  /** Lines that name their own file. */
  public static final BatchOutputFormat LINES = new BatchOutputFormat("", "", "");

  /** Texts with an empty line between them. */
  public static final BatchOutputFormat TEXTS = new BatchOutputFormat("", "\n", "");

  /** JSON values, as one array. */
  public static final BatchOutputFormat JSON_ARRAY = new BatchOutputFormat("[\n", ",\n", "\n]\n");

  /** Creates the format of a table with one header row. */
  public static BatchOutputFormat table(String header) {
    return new BatchOutputFormat(header, "", "");
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
