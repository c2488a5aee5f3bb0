package org.selectiverenderer.authoring.versions;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * Finds references by name that would break if an object were moved to a file of its own, because
 * the scope of a DEF name is one file.
 */
final class CrossFileReferences {
  /** The node types besides geometry that a reduced version does not contain. */
  private static final List<String> LOST =
      List.of(
          "X3DLightNode",
          "X3DBindableNode",
          "X3DSensorNode",
          "X3DSoundNode",
          "X3DTimeDependentNode",
          "X3DInterpolatorNode",
          "X3DSequencerNode",
          "X3DTriggerNode",
          "X3DParticleSystemNode",
          "Billboard",
          "Anchor");

  private final ElementNodeMapping scene;
  private final ProblemCollector problems;

  CrossFileReferences(ElementNodeMapping scene, ProblemCollector problems) {
    this.scene = scene;
    this.problems = problems;
  }

  /**
   * Returns whether the elements can be moved to other files; reports the obstacles. A USE is none,
   * since {@link SharedNodes} leaves the scene its nodes.
   *
   * @param def the object's DEF name
   */
  boolean free(String def, List<DocumentElement> elements) {
    return free(def, elements, true);
  }

  /**
   * Returns whether the elements can be removed; reports the obstacles, of which a USE is one.
   *
   * @param def the object's DEF name
   */
  boolean unused(String def, List<DocumentElement> elements) {
    return free(def, elements, false);
  }

  private boolean free(String def, List<DocumentElement> elements, boolean shared) {
    Set<String> names = new HashSet<>();
    for (DocumentElement element : elements) {
      ElementScope.visitWithin(element, inner -> inner.def().ifPresent(names::add));
    }
    boolean[] free = {true};
    ElementScope.visit(
        elements.isEmpty() ? scene.elements().root() : elements.get(0),
        other -> {
          boolean inside = elements.stream().anyMatch(element -> element.contains(other));
          String tie = inside ? inside(other) : outside(other, def, names, shared);
          if (!tie.isEmpty()) {
            problems.error(
                other.location(),
                "%s, so the object '%s' cannot be replaced; nothing has been changed"
                    .formatted(tie, def));
            free[0] = false;
          }
        });
    return free[0];
  }

  /** Warns of nodes that are not geometry and so will be in version 1 only. */
  void warnOfLosses(String def, List<DocumentElement> elements) {
    elements.forEach(element -> warnOfLosses(def, element));
  }

  private void warnOfLosses(String def, DocumentElement element) {
    NodeView node = element.use().isPresent() ? null : scene.node(element);
    if (element.name().equals("ProtoInstance") && node instanceof ParsedNode body) {
      NodeTraversal.visit(List.of(body), inner -> warnOfLoss(def, inner, element));
      return; // the nodes given to its fields are among these
    }
    if (node != null) {
      warnOfLoss(def, node, element);
    }
    element.children().forEach(child -> warnOfLosses(def, child));
  }

  private void warnOfLoss(String def, NodeView node, DocumentElement at) {
    if (lost(node)) {
      problems.warning(
          at.location(),
          ("the %s is not geometry: only version 1 of the object '%s' keeps it, reduced "
                  + "versions have the geometry that is visible at the start")
              .formatted(node.type().name(), def));
    }
  }

  private static boolean lost(NodeView node) {
    return switch (node.type().name()) {
      case "Switch", "LOD" -> node.nodes("children").size() > 1;
      default ->
          LOST.stream().anyMatch(type -> node.type().is(type)) && !node.type().is("X3DTextureNode");
    };
  }

  private static String inside(DocumentElement element) {
    return switch (element.name()) {
      case "Script", "ProtoDeclare", "ExternProtoDeclare", "ROUTE", "IMPORT", "EXPORT" ->
          "a " + element.name() + " is part of it";
      default -> "";
    };
  }

  private static String outside(
      DocumentElement element, String def, Set<String> names, boolean shared) {
    String used = element.use().orElse("");
    if (!shared && (used.equals(def) || names.contains(used))) {
      return "'" + used + "' is used here (USE)";
    }
    if (element.name().equals("MetadataString")
        && element.text("name").orElse("").equals("field")) {
      // Levels of a field, written by versions --texture-percent and --shading or the enricher.
      String field = element.text("value").orElse("").replace("\"", "").strip();
      if (names.stream().anyMatch(name -> field.startsWith(name + "."))) {
        return "the field %s has levels here, which a version in a file of its own would not have"
            .formatted(field);
      }
    }
    List<String> ends =
        switch (element.name()) {
          case "ROUTE" -> List.of("fromNode", "toNode");
          case "EXPORT" -> List.of("localDEF");
          case "IMPORT" -> List.of("inlineDEF");
          default -> List.of();
        };
    for (String end : ends) {
      String name = element.text(end).orElse("");
      if (names.contains(name)) {
        return "the " + element.name() + " here refers to '" + name + "'";
      }
    }
    return "";
  }
}
