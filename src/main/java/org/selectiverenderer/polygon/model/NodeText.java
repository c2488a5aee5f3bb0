package org.selectiverenderer.polygon.model;

import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.x3d.FieldAccess;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.FieldType;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;

/**
 * Nodes as the XML of another file: the values that their file gives, DEF and USE as they were, and
 * relative urls turned to the other file's folder.
 */
final class NodeText {
  private final StringBuilder text;
  private final Path target;
  private final Map<NodeView, String> defined = new IdentityHashMap<>();

  /**
   * @param target the folder of the file that is written
   */
  NodeText(StringBuilder text, Path target) {
    this.text = text;
    this.target = target;
  }

  /**
   * Appends a node.
   *
   * @param container the field of the parent that holds it; empty at the top of a scene
   * @param folder that the node's relative urls start from
   */
  void append(NodeView node, String container, Path folder, int indent) {
    text.append(" ".repeat(indent)).append('<').append(node.type().name());
    String known = defined.get(node);
    if (known != null) {
      attribute("USE", known);
      container(node, container);
      text.append("/>\n");
      return;
    }
    if (node.name() != null) {
      attribute("DEF", node.name());
      defined.put(node, node.name());
    }
    container(node, container);
    boolean children = false;
    for (FieldDefinition field : node.type().fields()) {
      if (written(node, field)) {
        Object value = node.value(field.index());
        if (field.type().isNode()) {
          children |= value instanceof NodeView || !((List<?>) value).isEmpty();
        } else {
          attribute(field.name(), ValueText.of(field.type(), turned(field, value, folder)));
        }
      }
    }
    if (!children) {
      text.append("/>\n");
      return;
    }
    text.append(">\n");
    for (FieldDefinition field : node.type().fields()) {
      if (field.type().isNode() && written(node, field)) {
        children(node.value(field.index()), field.name(), folder, indent + 2);
      }
    }
    text.append(" ".repeat(indent)).append("</").append(node.type().name()).append(">\n");
  }

  private static boolean written(NodeView node, FieldDefinition field) {
    boolean stored =
        field.access() == FieldAccess.INITIALIZE_ONLY || field.access() == FieldAccess.INPUT_OUTPUT;
    return stored
        && node.value(field.index()) != null
        && node instanceof ParsedNode parsed
        && parsed.given(field.index());
  }

  private void children(Object value, String field, Path folder, int indent) {
    if (value instanceof NodeView child) {
      append(child, field, folder, indent);
    } else {
      for (Object child : (List<?>) value) {
        append((NodeView) child, field, folder, indent);
      }
    }
  }

  private void container(NodeView node, String container) {
    if (!container.isEmpty() && !container.equals(node.type().containerField())) {
      attribute("containerField", container);
    }
  }

  private void attribute(String name, String value) {
    text.append(' ').append(name).append("='").append(ValueText.escape(value)).append('\'');
  }

  private Object turned(FieldDefinition field, Object value, Path folder) {
    if (field.type() != FieldType.MFString
        || !field.name().toLowerCase(Locale.ROOT).endsWith("url")) {
      return value;
    }
    String[] urls = ((String[]) value).clone();
    for (int i = 0; i < urls.length; i++) {
      urls[i] = Urls.turned(urls[i], folder, target);
    }
    return urls;
  }
}
