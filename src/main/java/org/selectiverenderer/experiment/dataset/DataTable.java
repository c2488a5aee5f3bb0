package org.selectiverenderer.experiment.dataset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.base.decimal.DecimalText;

/** A table whose columns say what they mean. Cells are texts; null is a value that is missing. */
public final class DataTable {
  private static final int DECIMALS = 6;

  private final String name;
  private final String meaning;
  private final List<TableColumn> columns;
  private final List<List<@Nullable String>> rows = new ArrayList<>();

  /**
   * An empty one.
   *
   * @param name its file's name without ending
   * @param meaning what a row is, one sentence without a full stop
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

  /** Cells in the columns' order. */
  public List<List<@Nullable String>> rows() {
    return Collections.unmodifiableList(rows);
  }

  /**
   * Adds a row.
   *
   * @param cells one for each column: texts and numbers; null, an empty text and what is no finite
   *     number are missing
   */
  public void add(List<? extends @Nullable Object> cells) {
    if (cells.size() != columns.size()) {
      throw new IllegalArgumentException(name + " has " + columns.size() + " columns");
    }
    List<@Nullable String> row = new ArrayList<>();
    cells.forEach(cell -> row.add(text(cell)));
    rows.add(Collections.unmodifiableList(row));
  }

  /** The same of an array. */
  public void add(@Nullable Object... cells) {
    add(Arrays.asList(cells));
  }

  private static @Nullable String text(@Nullable Object cell) {
    if (cell instanceof Double number) {
      return Double.isFinite(number) ? DecimalText.rounded(number, DECIMALS) : null;
    }
    String text = cell == null ? "" : cell.toString();
    return text.isEmpty() ? null : text;
  }

  /** With a header and commas; a missing value is an empty cell. */
  public String csv() {
    CsvText text = CsvText.bare().row(columns.stream().map(TableColumn::name).toList());
    rows.forEach(row -> text.row(row.stream().map(cell -> cell == null ? "" : cell).toList()));
    return text.toString();
  }

  /** With a header and tabs, as BIDS wants it; a missing value is {@code n/a}. */
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

  /**
   * BIDS knows no quotation marks round a cell, so what divides cells and lines becomes a space.
   */
  private static String flat(String cell) {
    return cell.replaceAll("[\\t\\r\\n]+", " ");
  }
}
