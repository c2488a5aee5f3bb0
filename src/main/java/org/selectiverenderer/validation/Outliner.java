package org.selectiverenderer.validation;

import java.lang.reflect.Array;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
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
    List<ParsedNode> nodes = SceneNodes.all(scene);
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

  private static void release(ParsedNode node) {
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.given(field.index()) ? node.value(field.index()) : null;
      if (value != null && value.getClass().isArray() && Array.getLength(value) > LONG) {
        node.put(field.index(), field.type().zero());
      }
    }
  }
}
