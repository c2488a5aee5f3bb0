package org.selectiverenderer.statistics.data;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVPrinter;
import org.selectiverenderer.statistics.detection.Response;

/** Answers as the file that {@link ResponsesReader} reads. */
public final class ResponsesCsv {
  private ResponsesCsv() {}

  /** Lines, the last one ended. */
  public static String of(List<Response> responses) {
    StringBuilder out = new StringBuilder();
    try (CSVPrinter printer =
        new CSVPrinter(out, CSVFormat.RFC4180.builder().setRecordSeparator("\n").get())) {
      printer.printRecord(ResponseRow.COLUMNS);
      for (Response response : responses) {
        printer.printRecord(
            response.participant(),
            response.condition(),
            response.area(),
            response.object(),
            response.type(),
            response.present() ? "yes" : "no",
            response.yes() ? "yes" : "no",
            response.confidence() == 0 ? "" : response.confidence());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toString();
  }
}
