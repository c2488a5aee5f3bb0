package org.selectiverenderer.authoring.editing;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Creates edits of single fields: each edit changes one attribute, or the fieldValue of one field
 * of a prototype's instance; an edit of a DEF name also changes all references to it.
 */
public final class FieldEdits {
  private final SceneDocument document;
  private final FieldValueCheck check;

  public FieldEdits(SceneDocument document) {
    this.document = document;
    this.check = new FieldValueCheck(document);
  }

  /**
   * Validates a value: returns a sentence about its error; empty if it is valid.
   *
   * @param text the attribute's value, with character references replaced
   */
  public Optional<String> wrong(DocumentElement element, NodeField field, String text) {
    return check.wrong(element, field, text);
  }

  /**
   * Validates a value for {@link #alike} elements: returns a sentence about the first that cannot
   * take it; empty if all can.
   *
   * @param field of the first element
   */
  public Optional<String> wrong(List<DocumentElement> elements, NodeField field, String text) {
    return check
        .wrong(elements.get(0), field, text)
        .or(() -> wrongOfOthers(targets(elements, field), field));
  }

  /**
   * Returns why a field of {@link #alike} elements cannot be without a written value; empty if it
   * can.
   */
  public Optional<String> wrongReset(List<DocumentElement> elements, NodeField field) {
    return check
        .wrongReset(elements.get(0), field)
        .or(() -> wrongOfOthers(targets(elements, field), field));
  }

  /** Tells which other element has a value that cannot be changed: else they are as the first. */
  private Optional<String> wrongOfOthers(List<DocumentElement> targets, NodeField field) {
    return targets.stream()
        .skip(1)
        .flatMap(
            other ->
                check
                    .readOnly(other, field)
                    .map(
                        why ->
                            "%s in line %d: %s"
                                .formatted(other, document.location(other.start()).line(), why))
                    .stream())
        .findFirst();
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

  /**
   * Returns an element and those others that have the same fields: of its type, for an instance of
   * the same prototype. What refers to a node by USE, or lies in another of them, is left out.
   */
  public List<DocumentElement> alike(DocumentElement element, List<DocumentElement> others) {
    List<DocumentElement> found = new ArrayList<>(List.of(element));
    if (element.use().isEmpty()) {
      Optional<DocumentElement> prototype = prototype(element);
      String name = prototypeName(element);
      Set<DocumentElement> kind =
          others.stream()
              .filter(other -> other.attached() && other.name().equals(element.name()))
              .filter(other -> other.use().isEmpty() && prototype(other).equals(prototype))
              .filter(other -> prototypeName(other).equals(name)) // that may be declared nowhere
              .filter(other -> !other.contains(element))
              .collect(Collectors.toCollection(LinkedHashSet::new));
      kind.stream()
          .filter(other -> !element.contains(other) && !within(other, kind))
          .forEach(found::add);
    }
    return found;
  }

  private static boolean within(DocumentElement element, Set<DocumentElement> any) {
    Optional<DocumentElement> around = element.parent();
    while (around.isPresent() && !any.contains(around.get())) {
      around = around.get().parent();
    }
    return around.isPresent();
  }

  private Optional<DocumentElement> prototype(DocumentElement of) {
    return InterfaceFieldList.applies(of)
        ? InterfaceFieldList.declaration(document, prototypeName(of), of)
        : Optional.empty();
  }

  private static String prototypeName(DocumentElement of) {
    return InterfaceFieldList.applies(of) ? of.text("name").orElse("").strip() : "";
  }

  /**
   * Sets a field of {@link #alike} elements in one step; a name only of the first. A text without
   * quotation marks that is typed for strings is one string.
   */
  public Edit set(List<DocumentElement> elements, NodeField field, String value) {
    String spelled = spelled(field, value);
    return together("Set ", elements, field, each -> set(each, field, spelled));
  }

  private static String spelled(NodeField field, String value) {
    boolean strings = field.definition().filter(of -> of.type() == FieldType.MFString).isPresent();
    return strings && !value.isBlank() && value.indexOf('"') < 0
        ? FieldValueFormatter.strings(value.strip())
        : value;
  }

  /** Resets a field of {@link #alike} elements in one step; a name only of the first. */
  public Edit unset(List<DocumentElement> elements, NodeField field) {
    return together("Reset ", elements, field, each -> unset(each, field));
  }

  private static Edit together(
      String verb,
      List<DocumentElement> elements,
      NodeField field,
      Function<DocumentElement, Edit> edit) {
    List<DocumentElement> targets = targets(elements, field);
    if (targets.size() == 1) {
      return edit.apply(targets.get(0));
    }
    return new Edit(
        verb + field.name() + " of " + targets.size() + " nodes",
        targets.stream().flatMap(each -> edit.apply(each).changes().stream()).toList());
  }

  /**
   * Returns the elements that a value is for: the name of a node, or of its prototype, is its own.
   */
  private static List<DocumentElement> targets(List<DocumentElement> elements, NodeField field) {
    DocumentElement first = elements.get(0);
    boolean name =
        switch (field.name()) {
          case "DEF", "USE" -> field.ofPrototype().isEmpty();
          case "name" -> field.ofPrototype().isEmpty() && InterfaceFieldList.applies(first);
          default -> false;
        };
    return name ? List.of(first) : elements;
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
