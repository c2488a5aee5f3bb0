package org.selectiverenderer.runtime.scene;

import java.util.LinkedHashSet;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/** A node and all that stands in its fields, and in theirs, but for metadata. */
public final class NodesBelow {
  private NodesBelow() {}

  /** Each once, in the order in which they stand. */
  public static Set<Node> of(Node node) {
    Set<Node> all = new LinkedHashSet<>();
    add(node, all);
    return all;
  }

  private static void add(Node node, Set<Node> all) {
    if (!all.add(node)) {
      return;
    }
    for (FieldDefinition field : node.type().fields()) {
      if (field.name().equals("metadata")) {
        continue;
      }
      Object value = node.value(field.index());
      if (value instanceof Node child) {
        add(child, all);
      } else if (field.type() == FieldType.MFNode) {
        node.nodes(field.name()).forEach(child -> add(child, all));
      }
    }
  }
}
