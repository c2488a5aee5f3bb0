package org.selectiverenderer.authoring.editing;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Judges values of single fields before they are written: types, bounds, words and names. */
final class FieldValueCheck {
  private final SceneDocument document;

  FieldValueCheck(SceneDocument document) {
    this.document = document;
  }

  /**
   * Validates a value: returns a sentence about its error; empty if it is valid.
   *
   * @param text the attribute's value, with character references replaced
   */
  Optional<String> wrong(DocumentElement element, NodeField field, String text) {
    if (field.readOnly().isPresent()) {
      return field.readOnly();
    }
    if (field.ofPrototype().isPresent()) {
      return wrongInstance(element, field, field.ofPrototype().get(), text);
    }
    return switch (field.name()) {
      case "DEF" -> wrongName(element, text);
      case "USE" -> wrongUse(element, text);
      default ->
          field.name().equals("name") && InterfaceFieldList.applies(element)
              ? wrongPrototype(element, text)
              : field.definition().flatMap(of -> wrongValue(element, of, text));
    };
  }

  /** Returns why a field cannot be without a written value; empty if it can. */
  Optional<String> wrongReset(DocumentElement element, NodeField field) {
    boolean named =
        field.name().equals("DEF")
            || field.name().equals("name") && InterfaceFieldList.applies(element);
    return named && field.ofPrototype().isEmpty() ? wrong(element, field, "") : field.readOnly();
  }

  private Optional<String> wrongPrototype(DocumentElement instance, String name) {
    return InterfaceFieldList.declaration(document, name.strip(), instance).isPresent()
        ? Optional.empty()
        : Optional.of(
            name.isBlank()
                ? "An instance needs the name of its prototype."
                : "No prototype before this instance has the name " + name + ".");
  }

  private Optional<String> wrongInstance(
      DocumentElement instance, NodeField field, InterfaceField declared, String text) {
    return declared.declared()
        ? field.definition().flatMap(of -> wrongValue(instance, of, text))
        : Optional.of(
            "The prototype %s has no field %s.".formatted(declared.prototype(), field.name()));
  }

  private Optional<String> wrongValue(DocumentElement element, FieldDefinition field, String text) {
    FieldParser.Parsed parsed = new FieldParser().parse(field.type(), text);
    Optional<String> flaw =
        parsed.flaws().stream()
            .filter(each -> each.severity() == Problem.Severity.ERROR)
            .findFirst()
            .map(each -> sentence(each.message()));
    Object value = parsed.value();
    if (flaw.isPresent() || value == null) {
      return flaw.or(() -> Optional.of("This is not a value of type " + field.type() + "."));
    }
    Optional<FieldValueConstraints.Beyond> beyond =
        field.type().kind() == FieldType.Kind.STRING
            ? Optional.empty()
            : FieldValueConstraints.beyond(field, value);
    return beyond
        .map(of -> of.value() + " is not allowed: it " + of.bound() + ".")
        .or(() -> wrongWord(element, field, value));
  }

  private static Optional<String> wrongWord(
      DocumentElement element, FieldDefinition field, Object value) {
    boolean closed =
        !field.values().isEmpty() && !FieldValueConstraints.open(element.name(), field);
    if (!closed) {
      return Optional.empty();
    }
    List<String> given =
        value instanceof String[] strings
            ? List.of(strings)
            : value instanceof String string ? List.of(string) : List.of();
    return given.stream()
        .filter(word -> !word.isEmpty() && !FieldValueConstraints.words(field).contains(word))
        .findFirst()
        .map(
            word ->
                word
                    + " is not allowed here; choose one of "
                    + String.join(", ", FieldValueConstraints.words(field)));
  }

  /** Returns the parser's message without its second part about the consequences. */
  private static String sentence(String message) {
    int semicolon = message.indexOf(';');
    String first = semicolon < 0 ? message : message.substring(0, semicolon);
    return first.isEmpty() ? message : Character.toUpperCase(first.charAt(0)) + first.substring(1);
  }

  private Optional<String> wrongName(DocumentElement element, String name) {
    if (name.equals(element.def().orElse(""))) {
      return Optional.empty();
    }
    NodeEdits nodes = new NodeEdits(document);
    if (name.isEmpty()) {
      return nodes
          .reference(element)
          .map(
              by ->
                  "Line %d refers to this node by its name; change the name instead of removing it."
                      .formatted(document.location(by.start()).line()));
    }
    try {
      nodes.check(name, element);
      return Optional.empty();
    } catch (EditRejectedException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
  }

  private Optional<String> wrongUse(DocumentElement element, String name) {
    Optional<DocumentElement> of = document.tree().flatMap(tree -> tree.named(name, element));
    if (of.isEmpty()) {
      return Optional.of("No node has this name.");
    }
    return of.get().name().equals(element.name())
        ? Optional.empty()
        : Optional.of("The node of this name is of type " + of.get().name() + ".");
  }
}
