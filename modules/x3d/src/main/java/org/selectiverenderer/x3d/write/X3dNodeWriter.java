package org.selectiverenderer.x3d.write;

import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Writes nodes with their fields; the first occurrence of a node has its DEF, further ones are
 * USEs. For one file.
 */
public final class X3dNodeWriter {
  /** The selection of a node's values to write. */
  public enum Written {
    /** The values given in its file, whether or not they are the default. */
    GIVEN,
    /** The values that are not the default. */
    CHANGED
  }

  /** Converts the urls of a node for the file being written. */
  public interface UrlRule {
    /** Returns the url as the written file is to have it. */
    String written(NodeView node, String url);
  }

  private static final String SOURCE = "sourceCode";

  private final X3dWriter out;
  private final Written which;
  private final Map<NodeView, String> defined = new IdentityHashMap<>();
  private final Map<NodeView, String> wanted = new IdentityHashMap<>();
  private final Set<String> taken = new HashSet<>();

  /** Creates a writer of nodes that writes by another writer, to its file. */
  public X3dNodeWriter(X3dWriter out, Written which) {
    this.out = out;
    this.which = which;
  }

  /** Returns the DEF name of a node in the file; empty if it has not been written. */
  public String name(NodeView node) {
    return defined.getOrDefault(node, "");
  }

  /** Gives a DEF name to a node without one; to be called before the node is written. */
  public void called(NodeView node, String name) {
    wanted.put(node, name);
  }

  /**
   * Records a node as written.
   *
   * @return its DEF name in the file the first time: its own, or with a number where another node
   *     has that name; empty for further copies
   */
  public String define(NodeView node) {
    String name = node.name() == null ? wanted.get(node) : node.name();
    if (name == null || defined.containsKey(node)) {
      return "";
    }
    String free = name;
    for (int i = 2; !taken.add(free); i++) {
      free = name + "_" + i;
    }
    defined.put(node, free);
    return free;
  }

  /**
   * Writes a node with its fields, or its USE.
   *
   * @param container the field of the parent that contains it; empty at the top level
   */
  public void append(NodeView node, String container, UrlRule urls) {
    String known = name(node);
    if (!known.isEmpty()) {
      out.use(node.type(), known, container);
      return;
    }
    open(node, container);
    values(node, "", urls);
    nodes(node, "", urls);
    out.close();
  }

  /** Begins a node, as a copy without DEF if it has been written before. */
  public void open(NodeView node, String container) {
    out.node(node.type(), define(node), container);
  }

  /** Writes the values of a node, without nodes and one excluded field. */
  public void values(NodeView node, String without, UrlRule urls) {
    for (FieldDefinition field : node.type().fields().subList(0, node.type().ownFrom())) {
      boolean asText = field.type().isNode() || field.name().equals(SOURCE);
      Object value = asText ? null : written(node, field, without);
      if (value != null) {
        out.attribute(field.name(), FieldValueFormatter.of(turned(node, field, value, urls)));
      }
    }
  }

  /** Writes author-defined fields, child nodes (without one field), and the program of a node. */
  public void nodes(NodeView node, String without, UrlRule urls) {
    List<FieldDefinition> fields = node.type().fields();
    int ownFrom = node.type().ownFrom();
    fields.subList(ownFrom, fields.size()).forEach(field -> own(node, field, urls));
    for (FieldDefinition field : fields.subList(0, ownFrom)) {
      if (field.type().isNode()) {
        within(written(node, field, without), field.name(), urls);
      }
    }
    node.type()
        .field(SOURCE)
        .map(field -> (String) written(node, field, without))
        .ifPresent(out::code);
  }

  private void within(@Nullable Object value, String container, UrlRule urls) {
    if (value instanceof NodeView child) {
      append(child, container, urls);
    } else if (value instanceof List<?> children) {
      children.forEach(child -> append((NodeView) child, container, urls));
    }
  }

  /** Writes an author-defined field of a Script or shader (ISO/IEC 19776-1, 4.3.7). */
  private void own(NodeView node, FieldDefinition field, UrlRule urls) {
    out.open("field", "name", field.name(), "type", field.type().name());
    out.attribute("accessType", field.access().spelling());
    Object value = field.access().initialisable() ? node.value(field.index()) : null;
    if (field.type().isNode()) {
      within(value, "", urls);
    } else if (value != null) {
      out.attribute("value", FieldValueFormatter.of(value));
    }
    out.close();
  }

  /** Returns a field's value, or null if it is not written. */
  private @Nullable Object written(NodeView node, FieldDefinition field, String without) {
    boolean stored =
        field.access() == AccessType.INITIALIZE_ONLY || field.access() == AccessType.INPUT_OUTPUT;
    if (!stored || field.name().equals(without)) {
      return null;
    }
    Object value = node.value(field.index());
    boolean said =
        which == Written.GIVEN
            ? node instanceof ParsedNode parsed && parsed.given(field.index())
            : field.type().isNode() || !Objects.deepEquals(value, field.defaultValue());
    return said ? value : null;
  }

  private static Object turned(NodeView node, FieldDefinition field, Object value, UrlRule urls) {
    boolean leads =
        field.type() == FieldType.MFString && field.name().toLowerCase(Locale.ROOT).endsWith("url");
    if (!leads) {
      return value;
    }
    String[] all = ((String[]) value).clone();
    for (int i = 0; i < all.length; i++) {
      all[i] = urls.written(node, all[i]);
    }
    return all;
  }
}
