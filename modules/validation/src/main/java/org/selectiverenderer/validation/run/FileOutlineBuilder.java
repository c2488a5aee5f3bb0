package org.selectiverenderer.validation.run;

import java.lang.reflect.Array;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.GeometryMeasure;
import org.selectiverenderer.validation.SceneNodeIterator;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Builds file outlines: measures the geometry of a file, then releases its long values. */
final class FileOutlineBuilder {
  private static final int LONG = 256;

  private final GeometryMeasurer measurer = new GeometryMeasurer();

  FileOutline outline(SourceFile file, long bytes, XmlDocument document, X3dFile scene) {
    List<ParsedNode> nodes = SceneNodeIterator.all(scene);
    Map<ParsedNode, GeometryMeasure> measures = new IdentityHashMap<>();
    for (ParsedNode node : nodes) {
      if (node.type().is("X3DGeometryNode")) {
        measurer.measure(node).ifPresent(measure -> measures.put(node, measure));
      }
    }
    nodes.forEach(FileOutlineBuilder::release);
    return new FileOutline(file, bytes, scene, nodes, places(document), measures);
  }

  private static Map<SourceLocation, Map<String, SourceLocation>> places(XmlDocument document) {
    Map<SourceLocation, Map<String, SourceLocation>> places = new HashMap<>();
    for (DocumentElement element : document.elements()) {
      Map<String, SourceLocation> own = new HashMap<>();
      for (String field : told(element.name())) {
        element.attribute(field).ifPresent(found -> own.put(field, found.location()));
      }
      if (!own.isEmpty()) {
        places.put(element.location(), Map.copyOf(own));
      }
    }
    return places;
  }

  /** Returns the attributes that scene checks report. */
  private static List<String> told(String element) {
    return switch (element) {
      case "Switch" -> List.of("whichChoice");
      case "ProximitySensor" -> List.of("size", "enabled");
      default -> element.startsWith("Metadata") ? List.of("name", "value") : List.of("url");
    };
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
