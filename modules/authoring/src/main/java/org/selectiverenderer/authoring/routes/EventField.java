package org.selectiverenderer.authoring.routes;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;

/** A field of a node that sends or receives events. */
public record EventField(String name, FieldType type, AccessType access) {
  /** Returns whether it sends events. */
  public boolean sends() {
    return access.sendsEvents();
  }

  /** Returns whether it receives events. */
  public boolean receives() {
    return access.acceptsEvents();
  }

  /**
   * Returns the fields of a node that send or receive events: those of its type, and those that it
   * or its prototype declares.
   */
  public static List<EventField> of(DocumentElement node, NodeCatalogue catalogue) {
    Map<String, EventField> fields = new LinkedHashMap<>();
    declarations(node)
        .flatMap(element -> declared(element).stream())
        .forEach(field -> fields.put(field.name(), field));
    catalogue
        .find(node.name())
        .ifPresent(
            type ->
                type.fields().stream()
                    .map(field -> new EventField(field.name(), field.type(), field.access()))
                    .forEach(field -> fields.putIfAbsent(field.name(), field)));
    return fields.values().stream().filter(field -> field.sends() || field.receives()).toList();
  }

  /**
   * Returns the field of a name, also of one with the prefix {@code set_} or the suffix {@code
   * _changed}.
   *
   * @param input whether it is to receive events
   */
  static Optional<EventField> named(List<EventField> fields, String name, boolean input) {
    Optional<EventField> exact = exactly(fields, name);
    if (exact.isPresent()) {
      return exact;
    }
    String plain =
        input && name.startsWith("set_")
            ? name.substring("set_".length())
            : !input && name.endsWith("_changed")
                ? name.substring(0, name.length() - "_changed".length())
                : "";
    return exactly(fields, plain).filter(field -> field.access() == AccessType.INPUT_OUTPUT);
  }

  private static Optional<EventField> exactly(List<EventField> fields, String name) {
    return fields.stream().filter(field -> field.name().equals(name)).findFirst();
  }

  private static Stream<DocumentElement> declarations(DocumentElement node) {
    List<DocumentElement> found = new ArrayList<>();
    if (node.name().equals("ProtoInstance")) {
      String name = node.text("name").orElse("");
      ElementScope.visit(
          node,
          element -> {
            boolean declares =
                element.name().equals("ProtoDeclare")
                    || element.name().equals("ExternProtoDeclare");
            if (declares && element.text("name").filter(name::equals).isPresent()) {
              fields(element, found);
              element.children().stream()
                  .filter(child -> child.name().equals("ProtoInterface"))
                  .forEach(child -> fields(child, found));
            }
          });
    } else {
      fields(node, found);
    }
    return found.stream();
  }

  private static void fields(DocumentElement in, List<DocumentElement> found) {
    in.children().stream().filter(child -> child.name().equals("field")).forEach(found::add);
  }

  private static Optional<EventField> declared(DocumentElement element) {
    String name = element.text("name").orElse("").strip();
    Optional<FieldType> type =
        Stream.of(FieldType.values())
            .filter(each -> each.name().equals(element.text("type").orElse("").strip()))
            .findFirst();
    Optional<AccessType> access =
        Stream.of(AccessType.values())
            .filter(each -> each.spelling().equals(element.text("accessType").orElse("").strip()))
            .findFirst();
    return name.isEmpty() || type.isEmpty() || access.isEmpty()
        ? Optional.empty()
        : Optional.of(new EventField(name, type.get(), access.get()));
  }
}
