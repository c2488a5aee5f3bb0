package org.selectiverenderer.authoring.editing;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates edits of single fields: each edit changes one attribute, or the fieldValue of one field
 * of a prototype's instance; an edit of a DEF name also changes all references to it.
 */
public final class FieldEdits {
  private final SceneDocument document;

  public FieldEdits(SceneDocument document) {
    this.document = document;
  }

  /**
   * Validates a value: returns a sentence about its error; empty if it is valid.
   *
   * @param text the attribute's value, with character references replaced
   */
  public Optional<String> wrong(DocumentElement element, NodeField field, String text) {
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
  public Optional<String> wrongReset(DocumentElement element, NodeField field) {
    boolean named =
        field.name().equals("DEF")
            || field.name().equals("name") && InterfaceFieldList.applies(element);
    return named && field.ofPrototype().isEmpty() ? wrong(element, field, "") : field.readOnly();
  }

  private Optional<String> wrongPrototype(DocumentElement instance, String name) {
    return InterfaceFieldList.declaration(document, name.strip(), instance).isPresent()
        ? Optional.empty()
        : Optional.of(name.isBlank()
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

  /**
   * Sets the value of a field: an attribute, or a field of a prototype's instance.
   *
   * @param value the unescaped value
   * @throws EditRejectedException if the value or the element comes from an entity
   */
  public Edit set(DocumentElement element, NodeField field, String value) {
    String name = field.name();
    if (field.ofPrototype().isEmpty()) {
      return set(element, name, value);
    }
    List<DocumentElement> given = InterfaceFieldList.values(element, name);
    if (!given.isEmpty()) {
      DocumentElement last = given.get(given.size() - 1);
      boolean same = document.attribute(last, "value").filter(value::equals).isPresent();
      return new Edit(
          setting(element, name),
          same ? List.of() : List.of(document.layout().attribute(last, "value", value)));
    }
    return new Edit(setting(element, name), List.of(added(element, name, value)));
  }

  /** Adds a fieldValue behind the others, which follow IS and metadata of an instance. */
  private TextEdit added(DocumentElement instance, String name, String value) {
    SourceFormatter layout = document.layout();
    char quote = layout.quote(instance);
    String tag = document.text(instance.start() + 1, instance.tagEnd());
    String prefix = tag.substring(0, Math.max(0, tag.indexOf(instance.name())));
    String line =
        "<"
            + prefix
            + "fieldValue"
            + SourceFormatter.written("name", name, quote)
            + SourceFormatter.written("value", value, quote)
            + "/>";
    List<DocumentElement> before =
        instance.children().stream().filter(child -> child.name().equals("fieldValue")).toList();
    return before.isEmpty()
        ? layout.insertLast(instance, List.of(line))
        : layout.insertAfter(before.get(before.size() - 1), List.of(line));
  }

  /** Returns the edit that lets the default of a field apply; an empty one if it does. */
  public Edit unset(DocumentElement element, NodeField field) {
    if (field.ofPrototype().isEmpty()) {
      return unset(element, field.name());
    }
    return new Edit(
        resetting(element, field.name()),
        InterfaceFieldList.values(element, field.name()).stream()
            .map(document.layout()::remove)
            .toList());
  }

  private static String setting(DocumentElement element, String name) {
    return "Set " + name + " of " + element;
  }

  private static String resetting(DocumentElement element, String name) {
    return "Reset " + name + " of " + element;
  }

  /**
   * Sets the value of an attribute. A DEF name is changed together with all references.
   *
   * @param value the unescaped value
   */
  public Edit set(DocumentElement element, String name, String value) {
    if (name.equals("DEF")) {
      return new NodeEdits(document).rename(element, value);
    }
    boolean same = document.attribute(element, name).filter(value::equals).isPresent();
    return new Edit(
        setting(element, name),
        same ? List.of() : List.of(document.layout().attribute(element, name, value)));
  }

  /** Removes an attribute, so that the default applies; an empty edit if it is missing. */
  public Edit unset(DocumentElement element, String name) {
    List<TextEdit> changes =
        document.tag(element).attribute(name).stream().map(this::removed).toList();
    return new Edit(resetting(element, name), changes);
  }

  /** Returns the removal of an attribute with its preceding white space. */
  private TextEdit removed(SourceAttribute written) {
    CharSequence text = document.text();
    int from = written.from();
    while (text.charAt(from - 1) <= ' ') {
      from--;
    }
    return TextEdit.remove(from, written.valueTo() + 1);
  }
}
