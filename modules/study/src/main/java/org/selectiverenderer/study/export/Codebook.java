package org.selectiverenderer.study.export;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.stream.Collectors;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.dataset.TableColumn;

/**
 * The codebook of some tables: type, unit, levels and meaning of every column, as CSV and as JSON.
 */
final class Codebook {
  private Codebook() {}

  /** Returns the codebook as CSV, with a row for each column. */
  static String csv(List<DataTable> tables) {
    DataTable book =
        new DataTable(
            "codebook",
            "a column of a table",
            List.of(
                TableColumn.text("file", "the table's file"),
                TableColumn.text("column", "the column's name"),
                TableColumn.text("type", "what its cells are"),
                TableColumn.text("unit", "of its numbers"),
                TableColumn.text("levels", "the values it can have, joined by |"),
                TableColumn.text("meaning", "what it says")));
    for (DataTable table : tables) {
      for (TableColumn column : table.columns()) {
        book.add(
            table.name() + ".csv",
            column.name(),
            column.type().spelling(),
            column.unit(),
            String.join("|", column.levels().keySet()),
            column.meaning()
                + column.levels().entrySet().stream()
                    .map(level -> level.getKey() + ": " + level.getValue())
                    .collect(
                        Collectors.joining(
                            "; ",
                            column.levels().isEmpty() ? "" : " (",
                            column.levels().isEmpty() ? "" : ")")));
      }
    }
    return book.csv();
  }

  /** Returns the codebook as JSON, by file and column. */
  static String json(List<DataTable> tables) {
    ObjectNode root = JsonTree.object();
    for (DataTable table : tables) {
      ObjectNode file = root.putObject(table.name() + ".csv");
      file.put("row", table.meaning()).put("rows", table.rows().size());
      ObjectNode columns = file.putObject("columns");
      for (TableColumn column : table.columns()) {
        ObjectNode node = columns.putObject(column.name());
        node.put("type", column.type().spelling()).put("meaning", column.meaning());
        if (!column.unit().isEmpty()) {
          node.put("unit", column.unit());
        }
        if (!column.levels().isEmpty()) {
          ObjectNode levels = node.putObject("levels");
          column.levels().forEach(levels::put);
        }
      }
    }
    return JsonWriter.of(root);
  }
}
