package org.selectiverenderer.x3d.write;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Finds the values of fields of prototypes that declare none: they are those of the node fields in
 * the body to which IS connects them.
 */
final class InterfaceDefaults {
  private final NodeCatalogue catalogue;

  InterfaceDefaults(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Returns the value of a declared field as text; empty if no node field gives it. */
  Optional<String> of(DocumentElement field, FieldType type) {
    String name = field.text("name").orElse("");
    return field
        .parent()
        .filter(around -> around.name().equals("ProtoInterface"))
        .flatMap(DocumentElement::parent)
        .map(prototype -> connected(prototype, name, type));
  }

  private @Nullable String connected(DocumentElement within, String name, FieldType type) {
    for (DocumentElement child : within.children()) {
      if (child.name().equals("ProtoDeclare") || child.name().equals("ProtoInterface")) {
        continue; // Another prototype has an interface of its own.
      }
      String found =
          child.name().equals("connect")
                  && child.text("protoField").filter(name::equals).isPresent()
              ? value(child, type)
              : connected(child, name, type);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  private @Nullable String value(DocumentElement connect, FieldType type) {
    DocumentElement node = connect.parent().flatMap(DocumentElement::parent).orElse(null);
    NodeType nodeType = node == null ? null : catalogue.find(node.name()).orElse(null);
    String name = connect.text("nodeField").orElse("");
    if (node == null || nodeType == null) {
      return null;
    }
    for (DocumentElement own : node.children()) {
      if (own.name().equals("field") && own.text("name").filter(name::equals).isPresent()) {
        return own.attribute("value")
            .map(value -> value.value(type))
            .map(FieldValueFormatter::of)
            .orElse(null);
      }
    }
    FieldDefinition field = nodeType.field(name).orElse(null);
    if (field == null || field.type() != type || !field.access().initialisable()) {
      return null;
    }
    Object value = node.attribute(name).map(given -> given.value(type)).orElse(null);
    Object known = value == null ? field.defaultValue() : value;
    return known == null ? null : FieldValueFormatter.of(known);
  }
}
