package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
  private final Map<DocumentElement, Map<String, List<DocumentElement>>> connections =
      new IdentityHashMap<>();

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

  private @Nullable String connected(DocumentElement prototype, String name, FieldType type) {
    return connections
        .computeIfAbsent(prototype, InterfaceDefaults::connections)
        .getOrDefault(name, List.of())
        .stream()
        .map(connect -> value(connect, type))
        .filter(Objects::nonNull)
        .findFirst()
        .orElse(null);
  }

  /** Returns the connect elements of a prototype by the field that they connect, in order. */
  private static Map<String, List<DocumentElement>> connections(DocumentElement prototype) {
    Map<String, List<DocumentElement>> found = new HashMap<>();
    collect(prototype, found);
    return found;
  }

  private static void collect(DocumentElement within, Map<String, List<DocumentElement>> found) {
    for (DocumentElement child : within.children()) {
      if (child.name().equals("connect")) {
        child
            .text("protoField")
            .ifPresent(name -> found.computeIfAbsent(name, n -> new ArrayList<>()).add(child));
      } else if (!child.name().equals("ProtoDeclare") && !child.name().equals("ProtoInterface")) {
        collect(child, found); // Another prototype has an interface of its own.
      }
    }
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
