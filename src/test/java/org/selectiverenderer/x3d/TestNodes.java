package org.selectiverenderer.x3d;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Makes nodes for tests from the catalogue's tables. */
public final class TestNodes {
  private final Map<String, NodeType> types = new HashMap<>();

  public TestNodes() {
    Map<String, List<FieldDefinition>> fields = new LinkedHashMap<>();
    for (String[] row : rows("x3d-4.0-fields.tsv")) {
      if (row[2].startsWith("xs:")) {
        continue;
      }
      List<FieldDefinition> list = fields.computeIfAbsent(row[0], name -> new ArrayList<>());
      FieldType type = FieldType.valueOf(row[2]);
      list.add(
          new FieldDefinition(
              list.size(),
              row[1],
              type,
              FieldAccess.of(row[3]),
              row[4],
              "",
              "",
              List.of(),
              List.of(),
              value(type, row[4])));
    }
    for (String[] row : rows("x3d-4.0-nodes.tsv")) {
      List<FieldDefinition> list = fields.getOrDefault(row[0], List.of());
      types.put(
          row[0],
          new NodeType(
              row[0], row[1], Integer.parseInt(row[2]), row[3], Set.of(row[4].split(" ")), list));
    }
  }

  public NodeType type(String name) {
    return types.get(name);
  }

  /** A node; fields alternate names and values. */
  public ParsedNode node(String typeName, Object... fields) {
    NodeType type = types.get(typeName);
    ParsedNode node = new ParsedNode(type, null, new Location("test.x3d", 1, 1));
    for (int i = 0; i < fields.length; i += 2) {
      node.put(type.indexOf((String) fields[i]), fields[i + 1]);
    }
    return node;
  }

  private static Object value(FieldType type, String text) {
    if (text.isEmpty() || type.isNode()) {
      return type.zero();
    }
    String[] words = text.trim().split("[\\s,]+");
    return switch (type.kind()) {
      case BOOLEAN -> Boolean.valueOf(text);
      case INT -> type.multiple() || words.length > 1 ? ints(words) : Integer.valueOf(text);
      case FLOAT -> type.multiple() || type.components() > 1 ? floats(words) : Float.valueOf(text);
      case DOUBLE ->
          type.multiple() || type.components() > 1 ? new double[0] : Double.valueOf(text);
      case STRING -> type.multiple() ? new String[] {text.replace("\"", "")} : text;
      case NODE -> type.zero();
    };
  }

  private static int[] ints(String[] words) {
    int[] values = new int[words.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = Integer.parseInt(words[i]);
    }
    return values;
  }

  private static float[] floats(String[] words) {
    float[] values = new float[words.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = Float.parseFloat(words[i]);
    }
    return values;
  }

  private static List<String[]> rows(String resource) {
    List<String[]> rows = new ArrayList<>();
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(
                NodeType.class.getResourceAsStream(resource), StandardCharsets.UTF_8))) {
      reader.readLine();
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        rows.add(line.split("\t", -1));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return rows;
  }
}
