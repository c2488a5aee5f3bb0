package org.selectiverenderer.study.design;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * A stimulus list: a table with a row for each stimulus.
 *
 * @param file the table
 * @param columns all its columns, in order
 * @param rows at least one
 */
public record StimulusList(Path file, List<String> columns, List<Stimulus> rows) {
  /**
   * A stimulus.
   *
   * @param line its line in the file, from 1
   * @param cells its cells by column
   * @param settings what its cells determine
   */
  public record Stimulus(int line, Map<String, String> cells, TrialSettings settings) {}

  public StimulusList {
    columns = List.copyOf(columns);
    rows = List.copyOf(rows);
  }
}
