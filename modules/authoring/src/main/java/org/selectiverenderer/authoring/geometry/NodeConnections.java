package org.selectiverenderer.authoring.geometry;

import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/**
 * Tells which nodes of a tree have values that others may set or read: by a ROUTE, from a file that
 * inlines this one, or as fields of the prototype around them. Each scope is searched once, so a
 * changed tree needs another instance.
 */
final class NodeConnections {
  private static final List<String> ENDS = List.of("fromNode", "toNode", "localDEF");

  private final Map<DocumentElement, Set<String>> routed = new IdentityHashMap<>();

  /** Returns whether fields of a node are those of the prototype around it. */
  static boolean prototypes(DocumentElement node) {
    return node.children().stream().anyMatch(child -> child.name().equals("IS"));
  }

  /** Returns whether a ROUTE or an EXPORT of a node's scope names it. */
  boolean routed(DocumentElement node) {
    return node.def()
        .filter(
            def -> routed.computeIfAbsent(ElementScope.of(node), at -> names(node)).contains(def))
        .isPresent();
  }

  private static Set<String> names(DocumentElement anyInScope) {
    Set<String> names = new HashSet<>();
    ElementScope.visit(
        anyInScope,
        each -> {
          if (each.name().equals("ROUTE") || each.name().equals("EXPORT")) {
            ENDS.forEach(end -> each.text(end).ifPresent(names::add));
          }
        });
    return names;
  }
}
