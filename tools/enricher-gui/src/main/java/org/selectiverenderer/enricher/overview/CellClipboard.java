package org.selectiverenderer.enricher.overview;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;

/**
 * Converts cells to and from tab-separated text, as spreadsheets use it. A text whose first line
 * begins with {@code object} has a header: its cells go to the objects and schemas that it names,
 * wherever these are in the table.
 */
final class CellClipboard {
  private static final String OBJECT = "object";
  private final OverviewTableModel model;

  CellClipboard(OverviewTableModel model) {
    this.model = model;
  }

  /** Returns the bounding rectangle of some cells as text. */
  String copy(List<CellPosition> cells, boolean withNames) {
    TreeSet<Integer> rows = new TreeSet<>();
    TreeSet<Integer> columns = new TreeSet<>();
    for (CellPosition cell : cells) {
      rows.add(cell.row());
      columns.add(cell.column());
    }
    columns.remove(0);
    StringBuilder text = new StringBuilder();
    if (withNames) {
      text.append(OBJECT);
      columns.forEach(column -> text.append('\t').append(model.getColumnName(column)));
      text.append('\n');
    }
    for (int row : rows) {
      List<String> line = new ArrayList<>();
      if (withNames) {
        line.add(model.node(row).object());
      }
      columns.forEach(column -> line.add(String.valueOf(model.getValueAt(row, column))));
      text.append(String.join("\t", line)).append('\n');
    }
    return text.toString();
  }

  /**
   * Returns the cell values that a text sets.
   *
   * @param selected the target cells: a block goes to their upper left corner, a single value fills
   *     all of them
   * @throws EditRejectedException if a value is no degree, or the block does not fit into the table
   */
  Map<CellPosition, CellInput> paste(String text, List<CellPosition> selected) {
    List<List<String>> lines =
        text.lines().map(line -> Arrays.asList(line.split("\t", -1))).toList();
    if (lines.isEmpty()) {
      throw new EditRejectedException(Texts.of("overview.nothing"));
    }
    if (lines.get(0).get(0).strip().equalsIgnoreCase(OBJECT)) {
      return named(lines);
    }
    if (lines.size() == 1 && lines.get(0).size() == 1) {
      CellInput input = input(lines.get(0).get(0));
      Map<CellPosition, CellInput> cells = new LinkedHashMap<>();
      selected.stream().filter(cell -> cell.column() > 0).forEach(cell -> cells.put(cell, input));
      return cells;
    }
    return placed(lines, selected);
  }

  private Map<CellPosition, CellInput> placed(
      List<List<String>> lines, List<CellPosition> selected) {
    int top = selected.stream().mapToInt(CellPosition::row).min().orElse(0);
    int left = Math.max(1, selected.stream().mapToInt(CellPosition::column).min().orElse(1));
    Map<CellPosition, CellInput> cells = new LinkedHashMap<>();
    for (int i = 0; i < lines.size(); i++) {
      for (int j = 0; j < lines.get(i).size(); j++) {
        CellPosition at = new CellPosition(top + i, left + j);
        if (at.row() >= model.getRowCount() || at.column() >= model.getColumnCount()) {
          throw new EditRejectedException(
              Texts.of(
                  "overview.nofit",
                  lines.size(),
                  DecimalFormatter.grouped(lines.size()),
                  lines.get(i).size(),
                  DecimalFormatter.grouped(lines.get(i).size())));
        }
        cells.put(at, input(lines.get(i).get(j)));
      }
    }
    return cells;
  }

  private Map<CellPosition, CellInput> named(List<List<String>> lines) {
    Map<String, Integer> rows = new LinkedHashMap<>();
    for (int row = 0; row < model.getRowCount(); row++) {
      rows.putIfAbsent(model.node(row).object(), row);
    }
    List<String> heads = lines.get(0);
    Map<CellPosition, CellInput> cells = new LinkedHashMap<>();
    for (List<String> line : lines.subList(1, lines.size())) {
      Integer row = rows.get(line.get(0).strip());
      if (row == null) {
        throw new EditRejectedException(Texts.of("overview.noobject", line.get(0)));
      }
      for (int j = 1; j < line.size() && j < heads.size(); j++) {
        int column = 1 + model.schemas().indexOf(heads.get(j).strip());
        if (column == 0) {
          throw new EditRejectedException(Texts.of("overview.noschema", heads.get(j)));
        }
        cells.put(new CellPosition(row, column), input(line.get(j)));
      }
    }
    return cells;
  }

  private static CellInput input(String text) {
    return CellInput.of(text)
        .orElseThrow(() -> new EditRejectedException(Texts.of("overview.nodegree", text)));
  }
}
