package org.selectiverenderer.base.csv;

import java.util.Optional;
import org.selectiverenderer.base.problem.Location;

/** A row below the header; it has as many cells as the header, if need be empty ones. */
public final class CsvRow {
  private final CsvTable table;
  private final String[] cells;
  private final int start;
  private final int line;

  CsvRow(CsvTable table, String[] cells, int start, int line) {
    this.table = table;
    this.cells = cells;
    this.start = start;
    this.line = line;
  }

  /** The cell in that column, without space around it. */
  public String cell(String column) {
    return cells[table.index(column)];
  }

  /** The cell in that column; empty where there is no such column. */
  public String cellIfAny(String column) {
    return table.has(column) ? cell(column) : "";
  }

  /** That cell with a decimal point, should it be a number with the table's decimal comma. */
  public String decimal(String column) {
    return withPoint(cell(column));
  }

  String withPoint(String number) {
    return table.decimalSign().withPoint(number);
  }

  Optional<String> decimalClash(String number) {
    return table.decimalSign().clash(number, line);
  }

  /** Where that cell begins. */
  public Location location(String column) {
    return table.place(start, line, table.index(column));
  }

  /** Where the row begins. */
  public Location location() {
    return table.place(start, line, 0);
  }
}
