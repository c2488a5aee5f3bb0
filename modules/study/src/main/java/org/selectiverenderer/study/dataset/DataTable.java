package org.selectiverenderer.study.dataset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.csv.SpreadsheetText;

/** A table with documented columns. Cells are texts; null is a missing value. */
public final class DataTable {
  private static final int DECIMALS = 6;

  private final String name;
  private final String meaning;
  private final List<TableColumn> columns;
  private final List<List<@Nullable String>> rows = new ArrayList<>();

  /**
   * Makes an empty table.
   *
   * @param name name of the table's file without the extension
   * @param meaning what a row stands for, one sentence without a full stop
   */
  public DataTable(String name, String meaning, List<TableColumn> columns) {
    this.name = name;
    this.meaning = meaning;
    this.columns = List.copyOf(columns);
  }

  public String name() {
    return name;
  }

  public String meaning() {
    return meaning;
  }

  public List<TableColumn> columns() {
    return columns;
  }

  /** Returns the rows, each with its cells in the columns' order. */
  public List<List<@Nullable String>> rows() {
    return Collections.unmodifiableList(rows);
  }

  /**
   * Adds a row.
   *
   * @param cells one for each column: texts and numbers; null, an empty text and a number that is
   *     not finite are missing values
   */
  public void add(List<? extends @Nullable Object> cells) {
    if (cells.size() != columns.size()) {
      throw new IllegalArgumentException(name + " has " + columns.size() + " columns");
    }
    List<@Nullable String> row = new ArrayList<>();
    cells.forEach(cell -> row.add(text(cell)));
    rows.add(Collections.unmodifiableList(row));
  }

  /** Adds a row from an array of cells. */
  public void add(@Nullable Object... cells) {
    add(Arrays.asList(cells));
  }

  private static @Nullable String text(@Nullable Object cell) {
    if (cell instanceof Double number) {
      return Double.isFinite(number) ? DecimalFormatter.rounded(number, DECIMALS) : null;
    }
    String text = cell == null ? "" : cell.toString();
    return text.isEmpty() ? null : text;
  }

  /**
   * Returns the table as CSV with a header; a missing value is an empty cell, and text that a
   * spreadsheet would calculate has its mark.
   */
  public String csv() {
    CsvWriter text = CsvWriter.bare().row(columns.stream().map(TableColumn::name).toList());
    rows.forEach(
        row ->
            text.row(
                row.stream()
                    .map(cell -> cell == null ? "" : SpreadsheetText.marked(cell))
                    .toList()));
    return text.toString();
  }

  /**
   * Returns the table as tab-separated text with a header, as BIDS requires; a missing value is
   * {@code n/a}.
   */
  public String tsv() {
    StringBuilder text = new StringBuilder();
    line(text, columns.stream().map(TableColumn::name).toList());
    rows.forEach(row -> line(text, row));
    return text.toString();
  }

  private static void line(StringBuilder text, List<? extends @Nullable String> cells) {
    for (int i = 0; i < cells.size(); i++) {
      String cell = cells.get(i);
      text.append(i == 0 ? "" : "\t").append(cell == null ? "n/a" : flat(cell));
    }
    text.append('\n');
  }

  /** Replaces tabs and line ends by spaces: BIDS has no quotation marks around cells. */
  private static String flat(String cell) {
    return cell.replaceAll("[\\t\\r\\n]+", " ");
  }
}
