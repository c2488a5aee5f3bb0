package org.selectiverenderer.validation;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.X3dFile;

/** Makes outlines: measures the geometry of a file, then lets its long values go. */
final class Outliner {
  private static final int LONG = 256;

  private final Measurer measurer = new Measurer();

  FileOutline outline(SourceFile file, long bytes, X3dFile scene) {
    List<ParsedNode> nodes = nodes(scene);
    Map<ParsedNode, Measure> measures = new IdentityHashMap<>();
    for (ParsedNode node : nodes) {
      if (node.type().is("X3DGeometryNode")) {
        measurer.measure(node).ifPresent(measure -> measures.put(node, measure));
      }
    }
    nodes.forEach(Outliner::release);
    return new FileOutline(file, bytes, scene, nodes, measures);
  }

  /** All nodes, each once, parents first. */
  private static List<ParsedNode> nodes(X3dFile scene) {
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

  private static void release(ParsedNode node) {
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.given(field.index()) ? node.value(field.index()) : null;
      if (value != null && value.getClass().isArray() && Array.getLength(value) > LONG) {
        node.put(field.index(), field.type().zero());
      }
    }
  }
}
