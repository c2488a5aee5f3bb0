package org.selectiverenderer.formats.csv;

import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;

/** A row below the header, padded with empty cells to the length of the header. */
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

  /** Returns the cell in a column, without surrounding white space. */
  public String cell(String column) {
    return cells[table.index(column)];
  }

  /** Returns the cell in a column; empty if the table has no such column. */
  public String cellIfAny(String column) {
    return table.has(column) ? cell(column) : "";
  }

  /** Returns that cell, with the table's decimal comma, if any, replaced by a decimal point. */
  public String decimal(String column) {
    return withPoint(cell(column));
  }

  String withPoint(String number) {
    return table.decimalSign().withPoint(number);
  }

  Optional<String> decimalClash(String number) {
    return table.decimalSign().clash(number, line);
  }

  /** Returns where that cell begins in the file. */
  public SourceLocation location(String column) {
    return table.place(start, line, table.index(column));
  }

  /** Returns where the row begins in the file. */
  public SourceLocation location() {
    return table.place(start, line, 0);
  }
}
