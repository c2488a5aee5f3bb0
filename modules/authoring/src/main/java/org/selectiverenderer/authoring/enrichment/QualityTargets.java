package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.routes.EventField;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.FieldValueConstraints;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Finds the fields that can be a quality of an object: those of named nodes in the scope of its
 * Switch that receive values which metadata can hold; and judges values of them.
 */
public final class QualityTargets {
  private final SceneDocument document;

  private final NodeCatalogue catalogue;

  /** Finds fields in the document's present state. */
  public QualityTargets(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
  }

  /**
   * Returns nodes that have a field for a quality: those inside the object first, then the others,
   * each in document order.
   *
   * @param object the element of the Switch
   * @param part a part of the DEF names, in any letter case
   * @param limit the most nodes to return
   */
  public List<DocumentElement> nodes(DocumentElement object, String part, int limit) {
    String lower = part.toLowerCase(Locale.ROOT);
    List<DocumentElement> inside = new ArrayList<>();
    List<DocumentElement> outside = new ArrayList<>();
    ElementScope.visit(
        object,
        element -> {
          List<DocumentElement> found = object.contains(element) ? inside : outside;
          if (found.size() < limit
              && element.def().filter(d -> d.toLowerCase(Locale.ROOT).contains(lower)).isPresent()
              && !fields(element).isEmpty()) {
            found.add(element);
          }
        });
    inside.addAll(outside);
    return inside.subList(0, Math.min(limit, inside.size()));
  }

  /** Returns the fields of a node that can be a quality. */
  public List<EventField> fields(DocumentElement node) {
    boolean metadata = MetadataElement.isMetadata(node);
    if (metadata && node.text("name").flatMap(SchemaField::of).isPresent()) {
      return List.of(); // it says which schemas there are
    }
    return EventField.of(node, catalogue).stream()
        .filter(field -> field.access() == AccessType.INPUT_OUTPUT)
        .filter(field -> FieldQuality.TYPES.contains(field.type().name()))
        .filter(field -> !metadata || field.name().equals("value"))
        .filter(field -> !(node.name().equals("Switch") && field.name().equals("whichChoice")))
        .toList();
  }

  /** Returns the field that a reference means, if it can be a quality of the object. */
  public Optional<EventField> find(DocumentElement object, FieldReference target) {
    return node(object, target)
        .flatMap(
            node ->
                fields(node).stream()
                    .filter(field -> field.name().equals(target.field()))
                    .findFirst());
  }

  private Optional<DocumentElement> node(DocumentElement object, FieldReference target) {
    return document.tree().flatMap(tree -> tree.named(target.node(), object));
  }

  /** Returns a sentence about what is wrong with a reference; empty if nothing is. */
  public Optional<String> wrong(DocumentElement object, FieldReference target) {
    if (node(object, target).isEmpty()) {
      // The type of an imported node is in another file.
      return imported(target.node())
          ? Optional.empty()
          : Optional.of("No node of this file has the name " + target.node() + ".");
    }
    return find(object, target).isPresent()
        ? Optional.empty()
        : Optional.of(
            "%s has no field %s whose value can be chosen."
                .formatted(target.node(), target.field()));
  }

  private boolean imported(String name) {
    boolean[] found = {false};
    document
        .tree()
        .ifPresent(
            tree ->
                tree.root()
                    .visit(
                        element ->
                            found[0] |=
                                element.name().equals("IMPORT")
                                    && element
                                        .text("AS")
                                        .or(() -> element.text("importedDEF"))
                                        .filter(name::equals)
                                        .isPresent()));
    return found[0];
  }

  /** Returns a sentence about what is wrong with a value; empty if nothing is. */
  public Optional<String> wrong(
      DocumentElement object, FieldReference target, List<String> values) {
    Optional<EventField> field = find(object, target);
    if (field.isEmpty() || field.get().type().kind() == FieldType.Kind.STRING) {
      return Optional.empty();
    }
    FieldType type = field.get().type();
    FieldParser.Parsed parsed = new FieldParser().parse(type, String.join(" ", values));
    Object value = parsed.value();
    boolean flawed =
        parsed.flaws().stream().anyMatch(flaw -> flaw.severity() == Problem.Severity.ERROR);
    if (flawed || value == null) {
      return Optional.of(
          "\"%s\" is no value of type %s.".formatted(String.join(" ", values), type));
    }
    return definition(object, target)
        .flatMap(of -> FieldValueConstraints.beyond(of, value))
        .map(of -> of.value() + " is not allowed: it " + of.bound() + ".");
  }

  private Optional<FieldDefinition> definition(DocumentElement object, FieldReference target) {
    return node(object, target)
        .flatMap(node -> catalogue.find(node.name()))
        .flatMap(type -> type.field(target.field()));
  }

  /** Returns the value that a field has in the text, as the strings of a level. */
  public List<String> present(DocumentElement object, FieldReference target) {
    Optional<String> written =
        node(object, target).flatMap(node -> document.attribute(node, target.field()));
    String text =
        written.orElse(definition(object, target).map(FieldDefinition::defaultText).orElse(""));
    return strings(object, target) ? MFStringParser.strings(text) : List.of(text);
  }

  /** Returns what levels of a field most likely differ in. */
  public Quality proposed(DocumentElement object, FieldReference target) {
    Optional<DocumentElement> node = node(object, target);
    String name = node.flatMap(of -> of.text("name")).orElse("");
    String type = node.map(DocumentElement::name).orElse("");
    if (name.equals("shading")) {
      return Quality.SHADING;
    }
    if (name.equals("animationRate") || type.equals("TimeSensor")) {
      return Quality.ANIMATION;
    }
    if (type.endsWith("Light") || target.field().equals("emissiveColor")) {
      return Quality.LIGHT;
    }
    return type.endsWith("Texture") ? Quality.TEXTURES : Quality.POLYGONS;
  }

  /** Returns values as an author edits them: those of an MFString in quotation marks. */
  public String shown(DocumentElement object, FieldReference target, List<String> values) {
    return strings(object, target) ? FieldValueFormatter.strings(values) : String.join(" ", values);
  }

  /** Returns the values that an author wrote; a text without quotation marks is one string. */
  public List<String> values(DocumentElement object, FieldReference target, String text) {
    if (!strings(object, target)) {
      return List.of(text.strip());
    }
    if (text.isBlank()) {
      return List.of();
    }
    return text.indexOf('"') < 0 ? List.of(text.strip()) : MFStringParser.strings(text);
  }

  private boolean strings(DocumentElement object, FieldReference target) {
    return find(object, target).filter(of -> of.type() == FieldType.MFString).isPresent();
  }
}
