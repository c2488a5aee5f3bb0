package org.selectiverenderer.x3d;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * All concrete node types of X3D 4.0, read from two tables that are part of the program: {@code
 * x3d-4.0-nodes.tsv} and {@code x3d-4.0-fields.tsv}. Immutable; one instance is made at the start
 * and handed to whoever needs it.
 */
public final class NodeCatalogue {
  private static final String NODES = "x3d-4.0-nodes.tsv";
  private static final String FIELDS = "x3d-4.0-fields.tsv";

  private final Map<String, NodeType> types;

  private NodeCatalogue(Map<String, NodeType> types) {
    this.types = types;
  }

  /**
   * Reads the tables.
   *
   * @throws IllegalStateException if a table is missing or damaged, which is a fault of the build
   */
  public static NodeCatalogue load() {
    Map<String, List<FieldDefinition>> fields = new FieldTable().read(resource(FIELDS));
    Map<String, NodeType> types = new LinkedHashMap<>(512);
    Map<String, Set<String>> ancestors = new HashMap<>();
    for (String[] row : new Rows(resource(NODES), 5)) {
      // The 260 nodes descend from some 100 combinations of abstract types only.
      Set<String> above =
          ancestors.computeIfAbsent(
              row[4], list -> new HashSet<>(Arrays.asList(list.strip().split(" "))));
      types.put(
          row[0],
          new NodeType(
              row[0],
              row[1],
              Integer.parseInt(row[2]),
              row[3],
              above,
              fields.getOrDefault(row[0], List.of())));
    }
    return new NodeCatalogue(types);
  }

  /** The node type of exactly that name. */
  public Optional<NodeType> find(String name) {
    return Optional.ofNullable(types.get(name));
  }

  /**
   * The node type of a name that is known to be in the catalogue; for code that names the
   * standard's own nodes.
   *
   * @throws IllegalArgumentException if there is none
   */
  public NodeType get(String name) {
    NodeType type = types.get(name);
    if (type == null) {
      throw new IllegalArgumentException("X3D 4.0 has no node " + name);
    }
    return type;
  }

  /** All node types in alphabetical order. */
  public Collection<NodeType> all() {
    return Collections.unmodifiableCollection(types.values());
  }

  /** The node that somebody who wrote an unknown name probably meant. */
  public Optional<String> suggestion(String name) {
    return Spelling.nearest(name, types.keySet());
  }

  private static String resource(String name) {
    try (InputStream in = NodeCatalogue.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("the program's own table " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The rows of a table after its heading, each cut at its tabs. */
  static final class Rows implements Iterable<String[]> {
    private final List<String[]> rows = new ArrayList<>(4096);

    Rows(String text, int columns) {
      int at = text.indexOf('\n') + 1;
      while (at < text.length()) {
        int newline = text.indexOf('\n', at);
        int next = newline < 0 ? text.length() : newline;
        int end = text.charAt(next - 1) == '\r' ? next - 1 : next;
        String[] row = new String[columns];
        for (int column = 0; column < columns; column++) {
          int tab = column == columns - 1 ? end : text.indexOf('\t', at);
          row[column] = tab == at ? "" : text.substring(at, tab);
          at = tab + 1;
        }
        at = next + 1;
        rows.add(row);
      }
    }

    @Override
    public java.util.Iterator<String[]> iterator() {
      return rows.iterator();
    }
  }
}
