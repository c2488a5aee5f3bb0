package org.selectiverenderer.x3d.catalogue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.base.problem.SpellingSuggester;

/**
 * The catalogue of all concrete node types, read from four resources: the nodes and fields of X3D
 * 4.0 from {@code x3d-4.0-nodes.tsv} and {@code x3d-4.0-fields.tsv}, and further nodes and fields,
 * from drafts of X3D 4.1 or specific to X_ITE 11 and castle-engine 7, from {@code
 * x3d-4.1-nodes.tsv} and {@code x3d-4.1-fields.tsv}. One instance is loaded at start-up and passed
 * on; thread-safe. A node type is created on its first use, since a scene uses some 20 of the 260.
 */
public final class NodeCatalogue {
  private static final int COLUMNS = 5;

  private static final Comparator<String> ALPHABETICAL =
      String.CASE_INSENSITIVE_ORDER.thenComparing(Comparator.naturalOrder());

  private final Map<String, String> rows;
  private final FieldTable fields;
  private final Map<String, NodeType> types = new ConcurrentHashMap<>();

  private NodeCatalogue(Map<String, String> rows, FieldTable fields) {
    this.rows = rows;
    this.fields = fields;
  }

  /**
   * Reads the tables.
   *
   * @throws IllegalStateException if a table is missing, which is an error of the build
   */
  public static NodeCatalogue load() {
    Map<String, String> rows = new TreeMap<>(ALPHABETICAL);
    read(resource("x3d-4.0-nodes.tsv"), rows);
    read(resource("x3d-4.1-nodes.tsv"), rows);
    return new NodeCatalogue(
        rows, new FieldTable(resource("x3d-4.0-fields.tsv"), resource("x3d-4.1-fields.tsv")));
  }

  private static void read(String nodes, Map<String, String> rows) {
    for (int at = nodes.indexOf('\n') + 1; at < nodes.length(); ) {
      int end = nodes.indexOf('\n', at);
      rows.put(nodes.substring(at, nodes.indexOf('\t', at)), nodes.substring(at, end));
      at = end + 1;
    }
  }

  /** Returns the node type of exactly this name. */
  public Optional<NodeType> find(String name) {
    NodeType type = types.get(name);
    return type != null ? Optional.of(type) : make(name);
  }

  /**
   * Returns the node type of a name that is known to be in the catalogue, for code that names nodes
   * of the standard.
   *
   * @throws IllegalArgumentException if there is none
   */
  public NodeType get(String name) {
    return find(name)
        .orElseThrow(() -> new IllegalArgumentException("X3D 4.0 has no node " + name));
  }

  /** Returns all node types in alphabetical order. */
  public List<NodeType> all() {
    List<NodeType> all = new ArrayList<>(rows.size());
    for (String name : rows.keySet()) {
      all.add(get(name));
    }
    return Collections.unmodifiableList(all);
  }

  /** Returns the names of all node types in alphabetical order. */
  public Set<String> names() {
    return rows.keySet();
  }

  /** Returns the node type name most similar to an unknown one, if any. */
  public Optional<String> suggestion(String name) {
    return SpellingSuggester.nearest(name, rows.keySet());
  }

  private Optional<NodeType> make(String name) {
    String row = rows.get(name);
    if (row == null) {
      return Optional.empty();
    }
    String[] cells = FieldTable.cells(row, COLUMNS);
    NodeType made =
        new NodeType(
            name,
            cells[1],
            Integer.parseInt(cells[2]),
            cells[3],
            new HashSet<>(Arrays.asList(cells[4].split(" "))),
            fields.of(name));
    // types are compared by identity, so that only the first of two threads may publish its type
    NodeType first = types.putIfAbsent(name, made);
    return Optional.of(first != null ? first : made);
  }

  private static String resource(String name) {
    try (InputStream in = NodeCatalogue.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("the program's resource " + name + " is missing");
      }
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      // git may have converted the line ends at checkout
      return text.indexOf('\r') < 0 ? text : text.replace("\r\n", "\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
