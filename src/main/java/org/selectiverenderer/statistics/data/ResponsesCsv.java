package org.selectiverenderer.statistics.data;

import java.util.List;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.statistics.detection.Response;

/** Answers as the file that {@link ResponsesReader} reads. */
public final class ResponsesCsv {
  private ResponsesCsv() {}

  /** Lines, the last one ended. */
  public static String of(List<Response> responses) {
    CsvText table = new CsvText().row(ResponseRow.COLUMNS);
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
