package org.selectiverenderer.authoring.placement;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StatementNames;

/**
 * Tells what the children of a group mean to it: whether they act on it alone, and whether its
 * coordinates mean anything to them. A USE means what its original does, an instance what the first
 * node of its prototype does.
 */
final class ChildSemantics {
  private static final String INSTANCE = "ProtoInstance";
  private static final int NESTED = 8;

  /** Components of nodes that only compute: they have no coordinates. */
  private static final Set<String> COMPUTING =
      Set.of(
          "Time", "Interpolation", "Followers", "EventUtilities", "Scripting", "KeyDeviceSensor");

  private static final Set<String> PLACELESS =
      Set.of("X3DInfoNode", "X3DInterpolatorNode", "LoadSensor");

  private final SceneDocument document;
  private final NodeCatalogue catalogue;

  ChildSemantics(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
  }

  /** Returns whether a child acts on the group that it is in, or describes it. */
  boolean scoped(DocumentElement child) {
    DocumentElement meant = original(child);
    return child.text("containerField").filter(field -> !field.equals("children")).isPresent()
        || Set.of("LocalFog", "ClipPlane").contains(meant.name())
        || type(meant)
            .filter(
                type ->
                    local(type, meant)
                        || Stream.of("X3DPointingDeviceSensorNode", "X3DMetadataObject")
                            .anyMatch(type::is))
            .isPresent();
  }

  /** Returns whether a node is a light that lights its own group only (X3D 4.0, 17.2.1.2). */
  private static boolean local(NodeType type, DocumentElement light) {
    return type.is("X3DLightNode")
        && !light
            .text("global")
            .map(String::strip)
            .or(() -> type.field("global").map(field -> field.defaultText()))
            .filter("true"::equalsIgnoreCase)
            .isPresent();
  }

  /** Returns whether a child has a position or direction in the coordinates of its group. */
  boolean placed(DocumentElement child) {
    DocumentElement meant = original(child);
    return meant.name().equals(INSTANCE)
        || type(meant)
            .filter(type -> type.is("X3DChildNode"))
            .filter(type -> !COMPUTING.contains(type.component()))
            .filter(type -> PLACELESS.stream().noneMatch(type::is))
            .filter(type -> !type.name().endsWith("Interpolator")) // those of NURBS
            .isPresent();
  }

  private Optional<NodeType> type(DocumentElement node) {
    return catalogue.find(node.name());
  }

  /** Returns the node that a USE repeats or an instance begins with; itself if it is not known. */
  private DocumentElement original(DocumentElement child) {
    DocumentElement at = child;
    for (int depth = 0; depth < NESTED; depth++) {
      Optional<DocumentElement> next = at.use().isPresent() ? used(at) : firstOfPrototype(at);
      if (next.isEmpty()) {
        return at;
      }
      at = next.get();
    }
    return at;
  }

  private Optional<DocumentElement> used(DocumentElement use) {
    return document.tree().flatMap(tree -> tree.named(use.use().orElse(""), use));
  }

  private Optional<DocumentElement> firstOfPrototype(DocumentElement instance) {
    if (!instance.name().equals(INSTANCE)) {
      return Optional.empty();
    }
    return document
        .tree()
        .flatMap(
            tree -> instance.text("name").flatMap(name -> tree.prototype(name.strip(), instance)))
        .stream()
        .flatMap(declaration -> declaration.children().stream())
        .filter(part -> part.name().equals("ProtoBody"))
        .flatMap(body -> body.children().stream())
        .filter(node -> node.name().equals(INSTANCE) || !StatementNames.is(node.name()))
        .findFirst();
  }
}
