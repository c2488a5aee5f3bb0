package org.selectiverenderer.csv;

import java.util.List;
import org.selectiverenderer.x3d.Location;

/** A row below the header; it has as many cells as the header. */
public final class CsvRow {
  private final CsvTable table;
  private final List<String> cells;
  private final int line;

  CsvRow(CsvTable table, List<String> cells, int line) {
    this.table = table;
    this.cells = cells;
    this.line = line;
  }

  /** The cell in that column, without space around it. */
  public String cell(String column) {
    return cells.get(table.index(column)).strip();
  }

  /** Where that cell begins. */
  public Location location(String column) {
    return table.place(line, table.index(column));
  }

  /** Where the row begins. */
  public Location location() {
    return table.place(line, 0);
  }
}
