package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.polygon.model.Urls;
import org.selectiverenderer.polygon.model.ValueText;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.FieldAccess;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.FieldType;

/** Nodes of a running scene as XML: every value that is not the default, DEF and USE. */
final class NodeText {
  private final StringBuilder text;
  private final Path target;
  private final Map<Node, String> defined = new IdentityHashMap<>();

  /**
   * @param target the folder of the file that is written
   */
  NodeText(StringBuilder text, Path target) {
    this.text = text;
    this.target = target;
  }

  /** Whether a node stands in the file already. */
  boolean known(Node node) {
    return defined.containsKey(node);
  }

  /** The DEF name under which a node stands in the file; empty for none. */
  String name(Node node) {
    return defined.getOrDefault(node, "");
  }

  /**
   * Notes a node as standing in the file.
   *
   * @return the name that it gets there: its own the first time, none in further copies
   */
  String define(Node node) {
    if (node.name() == null || defined.containsKey(node)) {
      return "";
    }
    defined.put(node, node.name());
    return node.name();
  }

  /** Appends a node with all that is in it. */
  void append(Node node, String container, int indent) {
    String use = name(node);
    open(node, use.isEmpty() ? ShapeText.def(define(node)) : "", use, container, indent);
    if (!use.isEmpty()) {
      text.append("/>\n");
      return;
    }
    attributes(node, "");
    if (!hasNodes(node, "")) {
      text.append("/>\n");
      return;
    }
    text.append(">\n");
    nodes(node, "", indent + 2);
    close(node, indent);
  }

  /** The start of an element: name, DEF or USE, container field. */
  void open(Node node, String def, String use, String container, int indent) {
    text.append(" ".repeat(indent)).append('<').append(node.type().name()).append(def);
    if (!use.isEmpty()) {
      attribute("USE", use);
    }
    if (!container.isEmpty() && !container.equals(node.type().containerField())) {
      attribute("containerField", container);
    }
  }

  void close(Node node, int indent) {
    text.append(" ".repeat(indent)).append("</").append(node.type().name()).append(">\n");
  }

  void attribute(String name, String value) {
    text.append(' ').append(name).append("='").append(ValueText.escape(value)).append('\'');
  }

  /** The values of a node that are no nodes, but for one field. */
  void attributes(Node node, String without) {
    for (FieldDefinition field : node.type().fields()) {
      if (!field.type().isNode() && !field.name().equals(without) && written(node, field)) {
        Object value = node.value(field.index());
        attribute(field.name(), ValueText.of(field.type(), turned(node, field, value)));
      }
    }
  }

  boolean hasNodes(Node node, String without) {
    for (FieldDefinition field : node.type().fields()) {
      if (field.type().isNode() && !field.name().equals(without) && written(node, field)) {
        return true;
      }
    }
    return false;
  }

  /** The nodes in a node, but for those of one field. */
  void nodes(Node node, String without, int indent) {
    for (FieldDefinition field : node.type().fields()) {
      if (!field.type().isNode() || field.name().equals(without) || !written(node, field)) {
        continue;
      }
      Object value = node.value(field.index());
      if (value instanceof Node child) {
        append(child, field.name(), indent);
      } else if (value instanceof List<?> children) {
        for (Object child : children) {
          append((Node) child, field.name(), indent);
        }
      }
    }
  }

  private static boolean written(Node node, FieldDefinition field) {
    boolean stored =
        field.access() == FieldAccess.INITIALIZE_ONLY || field.access() == FieldAccess.INPUT_OUTPUT;
    Object value = node.value(field.index());
    return stored && value != null && !Objects.deepEquals(value, empty(field));
  }

  private static @Nullable Object empty(FieldDefinition field) {
    return field.type() == FieldType.MFNode ? List.of() : field.defaultValue();
  }

  private Object turned(Node node, FieldDefinition field, @Nullable Object value) {
    boolean urls =
        field.type() == FieldType.MFString && field.name().toLowerCase(Locale.ROOT).endsWith("url");
    if (!urls) {
      return Objects.requireNonNull(value);
    }
    Path from = Path.of(node.location().file()).toAbsolutePath().getParent();
    String[] all = ((String[]) Objects.requireNonNull(value)).clone();
    for (int i = 0; i < all.length && from != null; i++) {
      all[i] = Urls.turned(all[i], from, target);
    }
    return all;
  }
}
