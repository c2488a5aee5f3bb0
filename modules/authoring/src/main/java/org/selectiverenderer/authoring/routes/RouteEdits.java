package org.selectiverenderer.authoring.routes;

import java.util.List;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/** Creates the edits that add and delete ROUTEs. */
public final class RouteEdits {
  private final SceneDocument document;

  /** Edits the routes of a document. */
  public RouteEdits(SceneDocument document) {
    this.document = document;
  }

  /**
   * Returns whether a ROUTE may connect two fields: one sends, the other receives, their types are
   * the same (X3D 4.0, 4.4.8.2).
   */
  public static boolean fit(EventField from, EventField to) {
    return from.sends() && to.receives() && from.type() == to.type();
  }

  /**
   * Adds a ROUTE behind all nodes of its scope.
   *
   * @throws EditRejectedException if a node has no DEF name, or both are not in one scope
   */
  public Edit add(
      DocumentElement fromNode, EventField from, DocumentElement toNode, EventField to) {
    String source = name(fromNode);
    String target = name(toNode);
    if (!ElementScope.shared(fromNode, toNode)) {
      throw new EditRejectedException(
          "'%s' and '%s' are not in the same scope of names: a ROUTE cannot lead into or out of a prototype"
              .formatted(source, target));
    }
    DocumentElement into = scene(ElementScope.of(fromNode));
    char quote = document.layout().quote(fromNode);
    String route =
        "<ROUTE"
            + SourceFormatter.written("fromNode", source, quote)
            + SourceFormatter.written("fromField", from.name(), quote)
            + SourceFormatter.written("toNode", target, quote)
            + SourceFormatter.written("toField", to.name(), quote)
            + "/>";
    return new Edit(
        "Add a ROUTE from %s to %s".formatted(source, target),
        List.of(document.layout().insertLast(into, List.of(route))));
  }

  private static String name(DocumentElement node) {
    return node.def()
        .orElseThrow(
            () -> new EditRejectedException(node + " needs a DEF name to be part of a ROUTE"));
  }

  /** Returns the element of a scope that ROUTEs stand in: the Scene, or the body of a prototype. */
  private static DocumentElement scene(DocumentElement scope) {
    String wanted = scope.name().equals("ProtoDeclare") ? "ProtoBody" : "Scene";
    return scope.children().stream()
        .filter(child -> child.name().equals(wanted))
        .findFirst()
        .orElse(scope);
  }

  /** Deletes a ROUTE. */
  public Edit delete(SceneRoute route) {
    return new Edit(
        "Delete the ROUTE from %s to %s".formatted(route.fromNode(), route.toNode()),
        List.of(document.layout().remove(route.element())));
  }
}
