package org.selectiverenderer.authoring.editing;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;

/**
 * Lists the fields of an element with their written values: those that are attributes, and behind
 * them those that the prototype of an instance declares.
 */
public final class NodeFieldList {
  /**
   * The largest length of a value that is edited in a form; longer ones are edited in the source.
   */
  private static final int LONG = 4000;

  /** The largest length of a text that is searched for DEF names after every change. */
  private static final int SEARCHED = 3_000_000;

  private NodeFieldList() {}

  /**
   * Returns all fields of an element: first the written ones in the order of the text, then the
   * others of the catalogue, and those of the interface of an instance's prototype. For an element
   * unknown to the catalogue only the written ones are returned.
   */
  public static List<NodeField> of(
      SceneDocument document, NodeCatalogue catalogue, DocumentElement element) {
    Optional<NodeType> type = catalogue.find(element.name());
    List<NodeField> fields = new ArrayList<>();
    Set<String> given = new HashSet<>();
    for (SourceAttribute written : document.tag(element).attributes()) {
      if (!written.declaration() && given.add(written.name())) {
        fields.add(written(document, type, element, written));
      }
    }
    type.ifPresent(
        of -> {
          if (!given.contains("USE")) {
            add(fields, given, "DEF", Optional.empty(), element);
          }
          for (FieldDefinition field : of.fields()) {
            if (field.access().initialisable() && !field.type().isNode()) {
              add(fields, given, field.name(), Optional.of(field), element);
            }
          }
        });
    if (InterfaceFieldList.applies(element)) {
      add(fields, given, "DEF", Optional.empty(), element);
      fields.addAll(InterfaceFieldList.of(document, catalogue, element));
    }
    return fields;
  }

  private static void add(
      List<NodeField> fields,
      Set<String> given,
      String name,
      Optional<FieldDefinition> field,
      DocumentElement element) {
    if (!given.contains(name)) {
      fields.add(
          new NodeField(
              name,
              kind(field),
              field,
              Optional.empty(),
              choices(field),
              element.use().isPresent()
                  ? Optional.of(
                      "A USE reference has no fields of its own; change the original node.")
                  : Optional.empty(),
              Optional.empty()));
    }
  }

  private static NodeField written(
      SceneDocument document,
      Optional<NodeType> type,
      DocumentElement element,
      SourceAttribute written) {
    Optional<FieldDefinition> field =
        type.flatMap(of -> of.field(written.name()))
            .filter(found -> found.access().initialisable() && !found.type().isNode());
    boolean use = written.name().equals("USE");
    List<String> choices = use ? names(document, element) : choices(field);
    NodeField.Kind kind =
        use
            ? NodeField.Kind.CHOICE
            : isLong(Optional.of(written)) ? NodeField.Kind.TEXT : kind(field);
    return new NodeField(
        written.name(),
        kind,
        field,
        Optional.of(shown(written)),
        choices,
        readOnly(written),
        Optional.empty());
  }

  /** Returns whether a value is too long for a form. */
  static boolean isLong(Optional<SourceAttribute> written) {
    return written.filter(of -> of.valueTo() - of.valueFrom() > LONG).isPresent();
  }

  /** Returns why a value cannot be changed in a form; empty if it can. */
  static Optional<String> readOnly(SourceAttribute written) {
    if (written.fromEntity()) {
      return Optional.of("The value comes from an entity of the DOCTYPE; change it in the source.");
    }
    return isLong(Optional.of(written))
        ? Optional.of("The value is long; change it in the source.")
        : Optional.empty();
  }

  /** Returns a value as a form shows it: a long one shortened. */
  static String shown(SourceAttribute written) {
    return isLong(Optional.of(written))
        ? written.text().subSequence(written.valueFrom(), written.valueFrom() + 60) + " ..."
        : written.value();
  }

  static NodeField.Kind kind(Optional<FieldDefinition> field) {
    return field
        .map(
            of ->
                switch (of.type()) {
                  case SFBool -> NodeField.Kind.BOOLEAN;
                  case SFColor -> NodeField.Kind.COLOR;
                  case SFString ->
                      of.values().isEmpty() ? NodeField.Kind.TEXT : NodeField.Kind.CHOICE;
                  default -> NodeField.Kind.TEXT;
                })
        .orElse(NodeField.Kind.TEXT);
  }

  static List<String> choices(Optional<FieldDefinition> field) {
    return field
        .filter(of -> of.type() == FieldType.SFString)
        .map(of -> List.copyOf(FieldValueConstraints.words(of)))
        .orElse(List.of());
  }

  /**
   * Returns the DEF names of elements of the same type; none for a large text, where the search
   * would be slow.
   */
  private static List<String> names(SceneDocument document, DocumentElement element) {
    if (document.text().length() > SEARCHED) {
      return List.of();
    }
    return DefNameScanner.of(document.text(), element.start()).entrySet().stream()
        .filter(each -> each.getValue().equals(element.name()))
        .map(each -> each.getKey())
        .toList();
  }
}
