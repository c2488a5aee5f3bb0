package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.statistics.detection.Response;

/** Writes answers in the CSV format that {@link ResponsesReader} reads. */
public final class ResponsesCsvWriter {
  private ResponsesCsvWriter() {}

  /** Returns the CSV text; its last line is terminated. */
  public static String of(List<Response> responses) {
    CsvWriter table = new CsvWriter().row(ResponseRowParser.COLUMNS);
    for (Response response : responses) {
      table.row(
          response.participant(),
          response.condition(),
          response.area(),
          response.object(),
          response.type(),
          response.present() ? "yes" : "no",
          response.yes() ? "yes" : "no",
          response.confidence() == 0 ? "" : response.confidence());
    }
    return table.toString();
  }
}
