package org.selectiverenderer.validation.language;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The interface of a node for routes and IS: the fields of its node type and those that a script or
 * a prototype declares.
 *
 * @param owner name of the node in messages
 * @param type the node type; empty for a prototype
 * @param own the fields that {@code field} elements declare, by name
 */
record NodeInterface(String owner, Optional<NodeType> type, Map<String, Field> own) {
  /** A field. */
  record Field(String name, FieldType type, AccessType access) {
    static Field of(FieldDefinition definition) {
      return new Field(definition.name(), definition.type(), definition.access());
    }
  }

  /**
   * Returns the field that a {@code field} element declares; empty if the declaration is
   * incomplete.
   */
  static Optional<Field> declared(DocumentElement element) {
    String name = element.text("name").orElse("").strip();
    Optional<FieldType> type = type(element.text("type").orElse(""));
    Optional<AccessType> access = access(element.text("accessType").orElse(""));
    return name.isEmpty() || type.isEmpty() || access.isEmpty()
        ? Optional.empty()
        : Optional.of(new Field(name, type.get(), access.get()));
  }

  static Optional<FieldType> type(String name) {
    for (FieldType type : FieldType.values()) {
      if (type.name().equals(name.strip())) {
        return Optional.of(type);
      }
    }
    return Optional.empty();
  }

  static Optional<AccessType> access(String name) {
    for (AccessType access : AccessType.values()) {
      if (access.spelling().equals(name.strip())) {
        return Optional.of(access);
      }
    }
    return Optional.empty();
  }

  /**
   * Creates an interface with the fields that {@code field} elements among the given ones declare.
   */
  static NodeInterface of(String owner, Optional<NodeType> type, List<DocumentElement> elements) {
    Map<String, Field> own = new HashMap<>();
    for (DocumentElement element : elements) {
      if (element.name().equals("field")) {
        declared(element).ifPresent(field -> own.put(field.name(), field));
      }
    }
    return new NodeInterface(owner, type, own);
  }

  /** Returns the field of exactly that name. */
  Optional<Field> field(String name) {
    return Optional.ofNullable(own.get(name))
        .or(() -> type.flatMap(node -> node.field(name)).map(Field::of));
  }

  /**
   * Returns the field that receives or sends events under a name, such as {@code set_x} for {@code
   * x}.
   */
  Optional<Field> event(String name, boolean input) {
    Optional<Field> exact = field(name);
    if (exact.isPresent()) {
      return exact;
    }
    if (input && name.startsWith("set_")) {
      return field(name.substring("set_".length()))
          .filter(field -> field.access() == AccessType.INPUT_OUTPUT);
    }
    return !input && name.endsWith("_changed")
        ? field(name.substring(0, name.length() - "_changed".length()))
            .filter(field -> field.access() == AccessType.INPUT_OUTPUT)
        : Optional.empty();
  }

  List<String> names() {
    List<String> names = new ArrayList<>(own.keySet());
    type.ifPresent(node -> node.fields().forEach(field -> names.add(field.name())));
    names.sort(null);
    return names;
  }
}
