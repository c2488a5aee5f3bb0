package org.selectiverenderer.x3d.read;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/** Traverses the nodes of a file. */
public final class NodeTraversal {
  private NodeTraversal() {}

  /** Visits every node once, parents before children. */
  public static void visit(List<ParsedNode> roots, Consumer<ParsedNode> visitor) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    Deque<ParsedNode> open = new ArrayDeque<>(roots);
    while (!open.isEmpty()) {
      ParsedNode node = open.pop();
      if (node.name() != null && !seen.add(node)) {
        continue; // only a node with a DEF name can have several parents
      }
      visitor.accept(node);
      for (FieldDefinition field : node.type().fields()) {
        if (!node.given(field.index())) {
          continue;
        }
        if (field.type() == FieldType.SFNode && node.value(field.index()) instanceof ParsedNode n) {
          open.add(n);
        } else if (field.type() == FieldType.MFNode) {
          node.nodes(field.name()).forEach(child -> open.add((ParsedNode) child));
        }
      }
    }
  }
}
