package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Reads the table of fields. Most cells repeat (260 times {@code metadata}), so each distinct one
 * is kept and interpreted once.
 */
final class FieldTable {
  private final FieldParser parser = new FieldParser();
  private final Map<String, FieldType> types = new HashMap<>();
  private final Map<String, FieldAccess> accesses = new HashMap<>();
  private final Map<String, Object> defaults = new HashMap<>();
  private final Map<String, List<String>> lists = new HashMap<>();

  FieldTable() {
    for (FieldType type : FieldType.values()) {
      types.put(type.name(), type);
    }
    types.put("xs:NMTOKEN", FieldType.SFString);
    for (FieldAccess access : FieldAccess.values()) {
      accesses.put(access.spelling(), access);
    }
  }

  /** The fields of every node, in the table's order. */
  Map<String, List<FieldDefinition>> read(String table) {
    Map<String, List<FieldDefinition>> fields = new HashMap<>(512);
    for (String[] row : new NodeCatalogue.Rows(table, 9)) {
      FieldType type = types.get(row[2]);
      FieldAccess access = accesses.get(row[3]);
      if (type == null || access == null) {
        throw new IllegalStateException(
            "the program's own table of fields has a bad row for " + row[0] + "." + row[1]);
      }
      List<FieldDefinition> ofNode = fields.computeIfAbsent(row[0], name -> new ArrayList<>(16));
      ofNode.add(
          new FieldDefinition(
              ofNode.size(),
              row[1].intern(),
              type,
              access,
              row[4],
              row[5],
              row[6],
              allowed(type, row[7]),
              names(row[8]),
              defaultValue(type, row[4])));
    }
    return fields;
  }

  private @Nullable Object defaultValue(FieldType type, String text) {
    if (type == FieldType.SFNode) {
      return null;
    }
    return defaults.computeIfAbsent(
        type.name() + text,
        key -> {
          Object value = text.isEmpty() ? null : parser.parse(type, text).value();
          return value != null ? value : type.zero();
        });
  }

  private List<String> names(String cell) {
    return cell.isEmpty()
        ? List.of()
        : lists.computeIfAbsent(cell, text -> List.of(text.split("\\|")));
  }

  /**
   * The allowed values. The table quotes each; those of an MFString are quoted X3D text themselves
   * ({@code ""MIDDLE" "END""}), which stays.
   */
  private List<String> allowed(FieldType type, String cell) {
    if (cell.isEmpty()) {
      return List.of();
    }
    String between = type.multiple() ? "\"\" \"\"" : "\" \"";
    return lists.computeIfAbsent(
        cell,
        text -> {
          String[] values = text.substring(1, text.length() - 1).split(between);
          if (type.multiple()) {
            for (int i = 0; i < values.length; i++) {
              values[i] = (i == 0 ? "" : "\"") + values[i] + (i == values.length - 1 ? "" : "\"");
            }
          }
          return List.of(values);
        });
  }
}
