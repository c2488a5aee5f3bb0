package org.selectiverenderer.validation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/** Enumerates the nodes of a file. */
public final class SceneNodeIterator {
  private SceneNodeIterator() {}

  /**
   * Returns all nodes, each once, parents first. The traversal is iterative, since USEs can nest as
   * deeply as the file is long.
   */
  public static List<ParsedNode> all(X3dFile scene) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<ParsedNode> found = new ArrayList<>();
    Deque<ParsedNode> waiting = new ArrayDeque<>();
    push(scene.allNodes(), waiting);
    for (ParsedNode node = waiting.poll(); node != null; node = waiting.poll()) {
      if (seen.add(node)) {
        found.add(node);
        push(children(node), waiting);
      }
    }
    return found;
  }

  private static void push(List<ParsedNode> nodes, Deque<ParsedNode> waiting) {
    for (int i = nodes.size() - 1; i >= 0; i--) {
      waiting.push(nodes.get(i));
    }
  }

  private static List<ParsedNode> children(ParsedNode node) {
    List<ParsedNode> children = new ArrayList<>();
    for (FieldDefinition field : node.type().fields()) {
      Object value =
          field.type().isNode() && node.given(field.index()) ? node.value(field.index()) : null;
      if (value instanceof List<?> list) {
        list.forEach(child -> children.add((ParsedNode) child));
      } else if (value != null) {
        children.add((ParsedNode) value);
      }
    }
    return children;
  }
}
