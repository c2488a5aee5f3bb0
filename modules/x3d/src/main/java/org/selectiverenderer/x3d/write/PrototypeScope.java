package org.selectiverenderer.x3d.write;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The prototypes that are visible in a scope, with their interfaces, and the nodes of the scope.
 */
final class PrototypeScope {
  private final @Nullable PrototypeScope enclosing;
  private final Map<String, DocumentElement> declared = new HashMap<>();
  private final Map<String, DocumentElement> nodes = new HashMap<>();

  PrototypeScope(@Nullable PrototypeScope enclosing) {
    this.enclosing = enclosing;
  }

  void declare(DocumentElement declaration) {
    declaration.text("name").ifPresent(name -> declared.put(name, declaration));
  }

  /** Adds a node with a name, which is known in this scope only. */
  void define(String name, DocumentElement node) {
    nodes.put(name, node);
  }

  /** Returns the latest node with a name; null if there is none. */
  @Nullable DocumentElement node(String name) {
    return nodes.get(name);
  }

  private @Nullable DocumentElement find(String name) {
    for (PrototypeScope at = this; at != null; at = at.enclosing) {
      DocumentElement found = at.declared.get(name);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  boolean has(String prototype) {
    return find(prototype) != null;
  }

  /** Returns the type of the field of a fieldValue; null if unknown. */
  @Nullable FieldType type(DocumentElement fieldValue) {
    String prototype = fieldValue.parent().flatMap(around -> around.text("name")).orElse("");
    return type(prototype, fieldValue.text("name").orElse(""));
  }

  private @Nullable FieldType type(String prototype, String field) {
    DocumentElement declaration = find(prototype);
    if (declaration == null) {
      return null;
    }
    for (DocumentElement child : declaration.children()) {
      if (child.name().equals("ProtoInterface")) {
        for (DocumentElement own : child.children()) {
          if (own.text("name").orElse("").equals(field)) {
            return declaredType(own);
          }
        }
      } else if (child.text("name").orElse("").equals(field)) {
        return declaredType(child);
      }
    }
    return null;
  }

  /** Returns the type in a field element; null if it has none. */
  static @Nullable FieldType declaredType(DocumentElement field) {
    return FieldTypeResolver.of(field.text("type").orElse(""));
  }

  /** Returns the node type of the first node of a prototype's body; null if unknown. */
  @Nullable NodeType node(String prototype, NodeCatalogue catalogue) {
    String name = prototype;
    // the limit ends the search in prototypes that contain themselves
    for (int depth = 0; depth < 100; depth++) {
      DocumentElement declaration = find(name);
      DocumentElement first = declaration == null ? null : first(declaration, catalogue);
      if (first == null) {
        return null;
      }
      if (!first.name().equals("ProtoInstance")) {
        return catalogue.find(first.name()).orElse(null);
      }
      name = first.text("name").orElse("");
    }
    return null;
  }

  private static @Nullable DocumentElement first(
      DocumentElement declaration, NodeCatalogue catalogue) {
    for (DocumentElement child : declaration.children()) {
      if (child.name().equals("ProtoBody")) {
        for (DocumentElement node : child.children()) {
          if (node.name().equals("ProtoInstance") || catalogue.find(node.name()).isPresent()) {
            return node;
          }
        }
      }
    }
    return null;
  }
}
