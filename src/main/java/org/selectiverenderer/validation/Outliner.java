package org.selectiverenderer.validation;

import java.lang.reflect.Array;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.DocumentElement;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.SceneDocument;
import org.selectiverenderer.x3d.X3dFile;

/** Makes outlines: measures the geometry of a file, then lets its long values go. */
final class Outliner {
  private static final int LONG = 256;

  private final Measurer measurer = new Measurer();

  FileOutline outline(SourceFile file, long bytes, SceneDocument document, X3dFile scene) {
    List<ParsedNode> nodes = nodes(scene);
    Map<ParsedNode, Measure> measures = new IdentityHashMap<>();
    for (ParsedNode node : nodes) {
      if (node.type().is("X3DGeometryNode")) {
        measurer.measure(node).ifPresent(measure -> measures.put(node, measure));
      }
    }
    nodes.forEach(Outliner::release);
    return new FileOutline(file, bytes, scene, nodes, urls(document), measures);
  }

  private static Map<Location, Location> urls(SceneDocument document) {
    Map<Location, Location> places = new HashMap<>();
    for (DocumentElement element : document.elements()) {
      element.attribute("url").ifPresent(url -> places.put(element.location(), url.location()));
    }
    return places;
  }

  /**
   * All nodes, each once, parents first. Without recursion: a chain of USEs is as deep as the file
   * is long.
   */
  private static List<ParsedNode> nodes(X3dFile scene) {
    Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    List<ParsedNode> found = new ArrayList<>();
    Deque<ParsedNode> waiting = new ArrayDeque<>();
    push(scene.nodes(), waiting);
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

  private static void release(ParsedNode node) {
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.given(field.index()) ? node.value(field.index()) : null;
      if (value != null && value.getClass().isArray() && Array.getLength(value) > LONG) {
        node.put(field.index(), field.type().zero());
      }
    }
  }
}
