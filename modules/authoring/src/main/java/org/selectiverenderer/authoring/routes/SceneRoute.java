package org.selectiverenderer.authoring.routes;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * A ROUTE of a document.
 *
 * @param type the type of the field at its start; empty if not known
 * @param fault what is wrong with it
 */
public record SceneRoute(
    DocumentElement element,
    String fromNode,
    String fromField,
    String toNode,
    String toField,
    Optional<FieldType> type,
    Fault fault) {
  /** Names what may be wrong with a ROUTE. */
  public enum Fault {
    /** Nothing is known to be wrong. */
    NONE,
    /** An attribute is missing. */
    INCOMPLETE,
    /** No node of its scope has the name at the start. */
    NO_SOURCE,
    /** No node of its scope has the name at the end. */
    NO_TARGET,
    /** The node at the start has no such field that sends events. */
    NOT_SENT,
    /** The node at the end has no such field that receives events. */
    NOT_RECEIVED,
    /** The types of the fields differ. */
    TYPES,
    /** The same ROUTE stands before. */
    REPEATED
  }

  /** A ROUTE as text and scope. */
  private record Connection(DocumentElement scope, List<String> ends) {}

  /** Returns the routes of a document in its order; none while it is not well-formed. */
  public static List<SceneRoute> in(SceneDocument document, NodeCatalogue catalogue) {
    List<SceneRoute> routes = new ArrayList<>();
    Set<Connection> seen = new HashSet<>();
    document
        .tree()
        .ifPresent(
            tree ->
                tree.root()
                    .visit(
                        element -> {
                          if (element.name().equals("ROUTE")) {
                            routes.add(of(element, tree, catalogue, seen));
                          }
                        }));
    return List.copyOf(routes);
  }

  private static SceneRoute of(
      DocumentElement element, ElementTree tree, NodeCatalogue catalogue, Set<Connection> seen) {
    List<String> ends =
        List.of("fromNode", "fromField", "toNode", "toField").stream()
            .map(name -> element.text(name).orElse("").strip())
            .toList();
    End from = End.of(ends.get(0), ends.get(1), element, tree, catalogue, false);
    End to = End.of(ends.get(2), ends.get(3), element, tree, catalogue, true);
    boolean fresh = seen.add(new Connection(ElementScope.of(element), ends));
    Optional<FieldType> type = from.field.map(EventField::type);
    boolean differ =
        from.field.isPresent()
            && to.field.isPresent()
            && !Objects.equals(type, to.field.map(EventField::type));
    Fault fault =
        ends.contains("")
            ? Fault.INCOMPLETE
            : from.missing
                ? Fault.NO_SOURCE
                : to.missing
                    ? Fault.NO_TARGET
                    : from.wrong
                        ? Fault.NOT_SENT
                        : to.wrong
                            ? Fault.NOT_RECEIVED
                            : differ ? Fault.TYPES : fresh ? Fault.NONE : Fault.REPEATED;
    return new SceneRoute(element, ends.get(0), ends.get(1), ends.get(2), ends.get(3), type, fault);
  }

  /**
   * An end of a ROUTE.
   *
   * @param missing whether no node has its name
   * @param wrong whether the node has no such field
   */
  private record End(boolean missing, boolean wrong, Optional<EventField> field) {
    static End of(
        String name,
        String field,
        DocumentElement route,
        ElementTree tree,
        NodeCatalogue catalogue,
        boolean input) {
      Optional<DocumentElement> node = tree.named(name, route);
      if (node.isEmpty()) {
        return new End(!imported(name, route), false, Optional.empty());
      }
      List<EventField> fields = EventField.of(node.get(), catalogue);
      boolean known = !fields.isEmpty() || catalogue.find(node.get().name()).isPresent();
      Optional<EventField> found =
          EventField.named(fields, field, input)
              .filter(each -> input ? each.receives() : each.sends());
      return new End(false, known && found.isEmpty(), found);
    }

    /** Returns whether a name comes from an inlined file, whose nodes are not known here. */
    private static boolean imported(String name, DocumentElement route) {
      boolean[] found = {false};
      ElementScope.visit(
          route,
          element ->
              found[0] |=
                  element.name().equals("IMPORT")
                      && name.equals(
                          element.text("AS").or(() -> element.text("importedDEF")).orElse("")));
      return found[0];
    }
  }
}
