package org.selectiverenderer.study.headlog;

import java.util.List;
import org.selectiverenderer.formats.csv.CsvWriter;

/** Writes a head log that is whole already, as {@link HeadLogWriter} writes one frame by frame. */
public final class HeadLogText {
  private HeadLogText() {}

  /** Returns the text of the CSV file, without the columns of gaze data. */
  public static String csv(List<HeadSample> samples) {
    List<HeadLogColumn> columns = HeadLogColumn.of(false);
    CsvWriter table = CsvWriter.bare();
    table.row(columns.stream().map(HeadLogColumn::header).toList());
    for (HeadSample sample : samples) {
      table.row(columns.stream().map(column -> column.cell(sample)).toList());
    }
    return table.toString();
  }
}
