package org.selectiverenderer.browser.scene;

import java.util.LinkedHashSet;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/** Collects a node and all nodes in its fields, recursively, except metadata. */
public final class NodeSubgraphCollector {
  private NodeSubgraphCollector() {}

  /** Returns the nodes, each once, in document order. */
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
      // The values of other fields stay as they are kept: to read a packed array would unpack it.
      if (field.type() == FieldType.SFNode) {
        if (node.value(field.index()) instanceof Node child) {
          add(child, all);
        }
      } else if (field.type() == FieldType.MFNode) {
        node.nodes(field.name()).forEach(child -> add(child, all));
      }
    }
  }
}
