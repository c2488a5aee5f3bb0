package org.selectiverenderer.document.nodes;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What speaks of a node by its DEF name, in the scene or the prototype's body that the name is
 * known in (X3D 4.0, 4.4.4.4).
 *
 * @param uses elements that stand for it by USE
 * @param routes from it or to it
 * @param exports of it
 * @param imports from the file that it inlines
 */
record NodeReferences(
    List<DocumentElement> uses,
    List<DocumentElement> routes,
    List<DocumentElement> exports,
    List<DocumentElement> imports) {
  private static final String BODY = "ProtoBody";

  NodeReferences {
    uses = List.copyOf(uses);
    routes = List.copyOf(routes);
    exports = List.copyOf(exports);
    imports = List.copyOf(imports);
  }

  /** What speaks of one node; nothing of one without a name. */
  static NodeReferences to(DocumentElement node) {
    return find(scope(node), node.def().map(Set::of).orElse(Set.of()), each -> true);
  }

  /** What outside of a node speaks of it or of anything in it. */
  static NodeReferences into(DocumentElement node) {
    Set<String> names = new HashSet<>();
    node.visit(each -> each.def().ifPresent(names::add));
    return find(scope(node), names, each -> !node.contains(each));
  }

  private interface Wanted {
    boolean test(DocumentElement element);
  }

  private static NodeReferences find(DocumentElement scope, Set<String> names, Wanted wanted) {
    List<DocumentElement> uses = new ArrayList<>();
    List<DocumentElement> routes = new ArrayList<>();
    List<DocumentElement> exports = new ArrayList<>();
    List<DocumentElement> imports = new ArrayList<>();
    visit(
        scope,
        each -> {
          if (!wanted.test(each)) {
            return;
          }
          if (each.use().filter(names::contains).isPresent()) {
            uses.add(each);
          }
          switch (each.name()) {
            case "ROUTE" -> {
              if (says(each, "fromNode", names) || says(each, "toNode", names)) {
                routes.add(each);
              }
            }
            case "EXPORT" -> {
              if (says(each, "localDEF", names)) {
                exports.add(each);
              }
            }
            case "IMPORT" -> {
              if (says(each, "inlineDEF", names)) {
                imports.add(each);
              }
            }
            default -> {}
          }
        });
    return new NodeReferences(uses, routes, exports, imports);
  }

  private static boolean says(DocumentElement element, String attribute, Set<String> names) {
    return element.text(attribute).filter(names::contains).isPresent();
  }

  /** The element within which the name of a node is known. */
  private static DocumentElement scope(DocumentElement node) {
    DocumentElement at = node;
    while (!at.name().equals(BODY) && at.parent().isPresent()) {
      at = at.parent().get();
    }
    return at;
  }

  private static void visit(DocumentElement in, Consumer<DocumentElement> visitor) {
    for (DocumentElement child : in.children()) {
      visitor.accept(child);
      if (!child.name().equals(BODY)) {
        visit(child, visitor);
      }
    }
  }
}
