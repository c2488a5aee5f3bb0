package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.routes.EventField;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Finds the fields of a document that are qualities of objects and that a ROUTE can set. */
final class ControlledFieldFinder {
  private final SceneDocument document;
  private final NodeCatalogue catalogue;
  private final ProblemCollector problems;
  private final FieldParser parser = new FieldParser();
  private final Set<FieldReference> routed;

  /**
   * Makes a finder for a document's present state.
   *
   * @param problems receives warnings of fields that cannot be set
   */
  ControlledFieldFinder(
      DocumentEnrichment enrichment, NodeCatalogue catalogue, ProblemCollector problems) {
    this.document = enrichment.document();
    this.catalogue = catalogue;
    this.problems = problems;
    this.routed = routed(document);
  }

  /** Returns the fields that are qualities of an object, in the order of its metadata. */
  List<ControlledField> of(EnrichedSwitch object) {
    return object.qualities().stream().flatMap(quality -> field(object, quality).stream()).toList();
  }

  private Optional<ControlledField> field(EnrichedSwitch object, FieldQuality quality) {
    FieldReference target = quality.target();
    SourceLocation location = object.element().location();
    Optional<DocumentElement> node =
        document.tree().flatMap(tree -> tree.named(target.node(), object.element()));
    if (node.isEmpty()) {
      return left(target, location, "the file itself has no node " + target.node());
    }
    Optional<FieldType> type =
        EventField.of(node.get(), catalogue).stream()
            .filter(field -> field.name().equals(target.field()))
            .filter(field -> field.access() == AccessType.INPUT_OUTPUT)
            .map(EventField::type)
            .filter(known -> FieldQuality.TYPES.contains(known.name()))
            .findFirst();
    if (type.isEmpty()) {
      return left(target, location, target.node() + " has no such field that metadata can set");
    }
    List<String> levels = new ArrayList<>();
    for (FieldLevel level : quality.levels()) {
      String text = text(type.get(), level.values());
      if (value(type.get(), text) == null) {
        return left(target, location, "\"%s\" is no value of it".formatted(text));
      }
      levels.add(text);
    }
    Optional<String> present = present(node.get(), target.field());
    int shown = present.map(text -> levelOf(type.get(), text, levels)).orElse(-1);
    return Optional.of(
        new ControlledField(
            target,
            type.get(),
            quality.schemas(),
            levels,
            shown,
            present.filter(text -> shown < 0 && value(type.get(), text) != null),
            routed.contains(target),
            location));
  }

  private Optional<ControlledField> left(
      FieldReference target, SourceLocation location, String reason) {
    problems.warning(location, "%s keeps its value in the export: %s".formatted(target, reason));
    return Optional.empty();
  }

  private static String text(FieldType type, List<String> values) {
    return type == FieldType.MFString
        ? FieldValueFormatter.strings(values)
        : String.join(" ", values);
  }

  /** Returns the value of a text, or null if it has none. */
  private @Nullable Object value(FieldType type, String text) {
    if (type == FieldType.MFString) {
      return MFStringParser.strings(text);
    }
    if (type == FieldType.SFString) {
      return text;
    }
    if (!type.multiple() && text.isBlank()) {
      return null;
    }
    FieldParser.Parsed parsed = parser.parse(type, text);
    boolean flawed =
        parsed.flaws().stream().anyMatch(flaw -> flaw.severity() == Problem.Severity.ERROR);
    return flawed ? null : parsed.value();
  }

  private int levelOf(FieldType type, String present, List<String> levels) {
    Object value = value(type, present);
    for (int level = 0; value != null && level < levels.size(); level++) {
      if (Objects.deepEquals(value, value(type, levels.get(level)))) {
        return level;
      }
    }
    return -1;
  }

  /** Returns the value of a field in the file, if the file or the type of the node tells it. */
  private Optional<String> present(DocumentElement node, String field) {
    return document
        .attribute(node, field)
        .or(
            () -> // a Script or an instance of a prototype
            node.children().stream()
                    .filter(child -> child.text("name").filter(field::equals).isPresent())
                    .flatMap(child -> child.text("value").stream())
                    .findFirst())
        .or(
            () ->
                catalogue
                    .find(node.name())
                    .flatMap(type -> type.field(field))
                    .map(FieldDefinition::defaultText));
  }

  /** Returns the fields of the document that a ROUTE sets. */
  private static Set<FieldReference> routed(SceneDocument document) {
    Set<FieldReference> found = new HashSet<>();
    document
        .tree()
        .ifPresent(tree -> tree.root().visit(element -> target(element).ifPresent(found::add)));
    return found;
  }

  /** Returns the field that an element sets if it is a ROUTE. */
  private static Optional<FieldReference> target(DocumentElement element) {
    if (!element.name().equals("ROUTE")) {
      return Optional.empty();
    }
    Optional<String> field =
        element.text("toField").map(name -> name.startsWith("set_") ? name.substring(4) : name);
    return element
        .text("toNode")
        .flatMap(node -> field.map(name -> new FieldReference(node, name)));
  }
}
