package org.selectiverenderer.authoring.nodes;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * The references to a node by its DEF name, within the {@link ElementScope} of the name.
 *
 * @param uses USE references to it
 * @param routes ROUTEs from it or to it
 * @param exports EXPORTs of it
 * @param imports IMPORTs from the file of an Inline
 */
record NodeReferences(
    List<DocumentElement> uses,
    List<DocumentElement> routes,
    List<DocumentElement> exports,
    List<DocumentElement> imports) {
  NodeReferences {
    uses = List.copyOf(uses);
    routes = List.copyOf(routes);
    exports = List.copyOf(exports);
    imports = List.copyOf(imports);
  }

  /** Finds the references to a node; none for a node without a name. */
  static NodeReferences to(DocumentElement node) {
    return find(node, node.def().map(Set::of).orElse(Set.of()), each -> true);
  }

  /** Finds the references from outside a node to it or to its descendants. */
  static NodeReferences into(DocumentElement node) {
    Set<String> names = new HashSet<>();
    ElementScope.visitWithin(node, each -> each.def().ifPresent(names::add));
    return find(node, names, each -> !node.contains(each));
  }

  private interface Wanted {
    boolean test(DocumentElement element);
  }

  private static NodeReferences find(DocumentElement node, Set<String> names, Wanted wanted) {
    List<DocumentElement> uses = new ArrayList<>();
    List<DocumentElement> routes = new ArrayList<>();
    List<DocumentElement> exports = new ArrayList<>();
    List<DocumentElement> imports = new ArrayList<>();
    ElementScope.visit(
        node,
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
}
