package org.selectiverenderer.authoring.versions;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.ParsedProtoInstance;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.XmlParseException;

/** A document as an element tree and as parsed nodes, with the mapping between them. */
final class ElementNodeMapping {
  private final DocumentSnapshot snapshot;
  private final ElementTree elements;
  private final X3dFile file;
  private final Map<SourceLocation, ParsedNode> nodes = new HashMap<>();

  private ElementNodeMapping(DocumentSnapshot snapshot, ElementTree elements, X3dFile file) {
    this.snapshot = snapshot;
    this.elements = elements;
    this.file = file;
    file.nodes().forEach(this::map);
    for (ParsedProtoInstance instance : file.instances().all()) {
      if (instance.within() < 0) {
        nodes.put(instance.location(), instance.node());
      }
    }
  }

  /**
   * @throws SceneNotEditableException if the text is read-only or not well-formed
   */
  static ElementNodeMapping of(
      DocumentSnapshot snapshot, X3dReader reader, ProblemCollector problems)
      throws SceneNotEditableException {
    String name = snapshot.name();
    if (snapshot.locked().isPresent()) {
      throw new SceneNotEditableException(name + ": " + snapshot.locked().get());
    }
    ElementTree elements;
    try {
      elements = snapshot.elements();
    } catch (XmlParseException e) {
      throw new SceneNotEditableException(e.fault().location() + ": " + e.getMessage());
    }
    return new ElementNodeMapping(snapshot, elements, reader.read(name, snapshot.text(), problems));
  }

  private void map(ParsedNode node) {
    if (nodes.putIfAbsent(node.location(), node) != null) {
      return;
    }
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.given(field.index()) ? node.value(field.index()) : null;
      if (value instanceof ParsedNode child) {
        map(child);
      } else if (value instanceof List<?> list) {
        list.forEach(child -> map((ParsedNode) child));
      }
    }
  }

  DocumentSnapshot snapshot() {
    return snapshot;
  }

  ElementTree elements() {
    return elements;
  }

  X3dFile file() {
    return file;
  }

  /**
   * Returns the node of an element of the scene, for a ProtoInstance the first node of its body;
   * null for statements such as ROUTE.
   */
  @Nullable NodeView node(DocumentElement element) {
    return element.use().isPresent()
        ? file.named().get(element.use().get())
        : nodes.get(element.location());
  }
}
