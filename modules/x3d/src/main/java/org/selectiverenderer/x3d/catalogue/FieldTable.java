package org.selectiverenderer.x3d.catalogue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The table of all fields, in which the rows of a node are consecutive. Repeated cells (260 times
 * {@code metadata}) are stored once. A second table has further fields of nodes of the first table,
 * and further nodes. Thread-safe.
 */
final class FieldTable {
  private static final int COLUMNS = 9;

  private final List<Rows> tables = new ArrayList<>(2);
  private final Map<String, String> words = new HashMap<>();
  private final Map<String, List<String>> lists = new HashMap<>();
  private final FieldParser parser = new FieldParser();

  /**
   * A table as text, and the offset of the first row of each node.
   *
   * @param starts offsets by the node's name and a tab
   */
  private record Rows(String table, Map<String, Integer> starts) {
    static Rows of(String table) {
      Map<String, Integer> starts = new HashMap<>(512);
      String node = "\n";
      int at = table.indexOf('\n') + 1;
      for (; at < table.length(); at = table.indexOf('\n', at) + 1) {
        if (!table.startsWith(node, at)) {
          node = table.substring(at, table.indexOf('\t', at) + 1);
          starts.put(node, at);
        }
      }
      return new Rows(table, starts);
    }
  }

  /** Creates the table from texts of LF-terminated lines, of which the first is the header. */
  FieldTable(String table, String further) {
    tables.add(Rows.of(table));
    tables.add(Rows.of(further));
  }

  /** Returns the fields of a node in the table's order. */
  synchronized List<FieldDefinition> of(String node) {
    String first = node + "\t";
    List<FieldDefinition> fields = new ArrayList<>(32);
    for (Rows rows : tables) {
      String table = rows.table();
      int at = rows.starts().getOrDefault(first, table.length());
      while (table.startsWith(first, at)) {
        int end = table.indexOf('\n', at);
        fields.add(field(fields.size(), cells(table.substring(at, end), COLUMNS)));
        at = end + 1;
      }
    }
    return fields;
  }

  private FieldDefinition field(int index, String[] cells) {
    FieldType type =
        cells[2].equals("xs:NMTOKEN") ? FieldType.SFString : FieldType.valueOf(cells[2]);
    return new FieldDefinition(
        index,
        once(cells[1]),
        type,
        AccessType.of(cells[3]),
        once(cells[4]),
        once(cells[5]),
        once(cells[6]),
        allowed(type, cells[7]),
        list(cells[8]),
        defaultValue(type, cells[4]));
  }

  private String once(String cell) {
    String known = words.putIfAbsent(cell, cell);
    return known == null ? cell : known;
  }

  private @Nullable Object defaultValue(FieldType type, String text) {
    if (type.isNode() || text.isEmpty()) {
      return type.zero();
    }
    Object value = parser.parse(type, text).value();
    return value != null ? value : type.zero();
  }

  private List<String> list(String cell) {
    if (cell.isEmpty()) {
      return List.of();
    }
    List<String> known = lists.get(cell);
    if (known == null) {
      known = List.of(cell.split("\\|"));
      lists.put(cell, known);
    }
    return known;
  }

  /**
   * Returns the allowed values. The table quotes each of them; those of an MFString are quoted X3D
   * text themselves ({@code ""MIDDLE" "END""}), whose inner quotes are kept.
   */
  private static List<String> allowed(FieldType type, String cell) {
    if (cell.isEmpty()) {
      return List.of();
    }
    String mark = type.multiple() ? "\"\"" : "\"";
    int kept = type.multiple() ? 1 : 0;
    List<String> values = new ArrayList<>();
    for (int at = 0; at < cell.length(); ) {
      int close = cell.indexOf(mark, at + mark.length());
      values.add(cell.substring(at + mark.length() - kept, close + kept));
      at = close + mark.length() + 1;
    }
    return List.copyOf(values);
  }

  /** Splits a row at its tabs. */
  static String[] cells(String row, int columns) {
    String[] cells = new String[columns];
    int at = 0;
    for (int column = 0; column < columns; column++) {
      int tab = row.indexOf('\t', at);
      int end = tab < 0 ? row.length() : tab;
      cells[column] = row.substring(at, end);
      at = end + 1;
    }
    return cells;
  }
}
