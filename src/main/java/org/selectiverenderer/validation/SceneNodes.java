package org.selectiverenderer.validation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.X3dFile;

/** The nodes of a file, wherever they stand. */
public final class SceneNodes {
  private SceneNodes() {}

  /** All nodes, each once, parents first. */
  public static List<ParsedNode> all(X3dFile scene) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<ParsedNode> found = new ArrayList<>();
    scene.nodes().forEach(node -> collect(node, seen, found));
    return found;
  }

  private static void collect(
      @Nullable ParsedNode node, Set<ParsedNode> seen, List<ParsedNode> found) {
    if (node == null || !seen.add(node)) {
      return;
    }
    found.add(node);
    for (FieldDefinition field : node.type().fields()) {
      if (!field.type().isNode() || !node.given(field.index())) {
        continue;
      }
      Object value = node.value(field.index());
      if (value instanceof List<?> list) {
        list.forEach(child -> collect((ParsedNode) child, seen, found));
      } else {
        collect((ParsedNode) value, seen, found);
      }
    }
  }
}
