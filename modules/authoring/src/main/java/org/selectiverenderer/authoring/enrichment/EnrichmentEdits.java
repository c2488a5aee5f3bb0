package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Creates edits of the schema metadata of a document's Switches and ProximitySensors. Each edit is
 * for the document's present state and is performed by {@link SceneDocument#perform}; an edit that
 * would change nothing is empty.
 *
 * <p>All throw {@link EditRejectedException}, with a sentence for the author, where metadata is
 * shared between nodes in a way that the edit would break, or the text is not well-formed.
 */
public final class EnrichmentEdits {
  private final DocumentEnrichment enrichment;
  private final SceneDocument document;

  public EnrichmentEdits(DocumentEnrichment enrichment) {
    this.enrichment = enrichment;
    this.document = enrichment.document();
  }

  /** The wanted metadata of a Switch: that of each choice in order. */
  public record SwitchMetadata(EnrichedSwitch node, List<ChoiceMetadata> choices) {
    public SwitchMetadata {
      choices = List.copyOf(choices);
      if (choices.size() != node.choices().size()) {
        throw new IllegalArgumentException(
            choices.size() + " for " + node.choices().size() + " choices");
      }
    }
  }

  /** The wanted metadata of a sensor. */
  public record SensorMetadata(EnrichedSensor node, SensorSchemas schemas) {}

  /** Sets the metadata of one choice of a Switch. */
  public Edit choice(EnrichedSwitch node, int index, ChoiceMetadata values) {
    List<ChoiceMetadata> wanted = new ArrayList<>(node.values());
    wanted.set(index, values);
    return all(
        "Describe choice %d of %s".formatted(index, node.name()),
        List.of(new SwitchMetadata(node, wanted)),
        List.of());
  }

  /** Sets the schemas of an area. */
  public Edit sensor(EnrichedSensor node, SensorSchemas schemas) {
    return all(
        "Set schemas of " + node.name(), List.of(), List.of(new SensorMetadata(node, schemas)));
  }

  /** Sets the metadata of many nodes as one undo step. */
  public Edit all(String name, List<SwitchMetadata> switches, List<SensorMetadata> sensors) {
    wellFormed();
    EnrichedNodeWriter writer = new EnrichedNodeWriter(document);
    List<TextEdit> changes = new ArrayList<>();
    for (SwitchMetadata wish : switches) {
      for (int i = 0; i < wish.choices().size(); i++) {
        List<String> there = wish.node().values().get(i).schemas();
        SchemaNameValidator.require(wish.choices().get(i).schemas(), there);
      }
      changes.addAll(writer.changes(wish.node(), wish.choices()));
    }
    for (SensorMetadata wish : sensors) {
      SchemaNameValidator.require(wish.schemas().enter(), wish.node().schemas().enter());
      SchemaNameValidator.require(wish.schemas().exit(), wish.node().schemas().exit());
      changes.addAll(writer.changes(wish.node(), wish.schemas()));
    }
    return new Edit(name, changes);
  }

  /**
   * Returns the metadata changes for a choice that is appended to a Switch: an empty MetadataSet,
   * if each existing choice has a MetadataSet of its own.
   */
  public List<TextEdit> choiceAdded(EnrichedSwitch node) {
    wellFormed();
    return new EnrichedNodeWriter(document).partAdded(node);
  }

  /** Returns the metadata changes for a choice that is removed. */
  public List<TextEdit> choiceRemoved(EnrichedSwitch node, int index) {
    wellFormed();
    return new EnrichedNodeWriter(document).partRemoved(node, index);
  }

  /** Renames a schema wherever it occurs; the name of another schema merges the two. */
  public Edit renameSchema(String from, String to) {
    wellFormed();
    String name = to.strip();
    if (name.isEmpty()) {
      throw new EditRejectedException("a schema needs a name of at least one letter");
    }
    SchemaNameValidator.require(List.of(name), List.of());
    List<TextEdit> changes = new ArrayList<>();
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              if (element.name().equals("MetadataString")) {
                rename(element, from, name, changes);
              }
            });
    return new Edit("Rename %s to %s".formatted(from, name), changes);
  }

  private void rename(DocumentElement element, String from, String to, List<TextEdit> changes) {
    boolean names =
        document
            .attribute(element, "name")
            .flatMap(SchemaField::of)
            .filter(EnrichmentEdits::namesSchemas)
            .isPresent();
    if (!names) {
      return;
    }
    List<String> values = MFStringParser.strings(document.attribute(element, "value").orElse(""));
    if (values.stream().anyMatch(value -> value.strip().equals(from))) {
      List<String> renamed =
          values.stream().map(value -> value.strip().equals(from) ? to : value).distinct().toList();
      changes.add(
          document.layout().attribute(element, "value", FieldValueFormatter.strings(renamed)));
    }
  }

  private static boolean namesSchemas(SchemaField field) {
    return switch (field) {
      case ENTER_TIME_SCHEMA, EXIT_TIME_SCHEMA, SCHEMA_BELONGINESS -> true;
      case CONSISTENCY_TYPE, DEGREE_OF_CONSISTENCY -> false;
    };
  }

  /** Removes a schema wherever it occurs. */
  public Edit removeSchema(String schema) {
    List<SwitchMetadata> switches = new ArrayList<>();
    for (EnrichedSwitch node : enrichment.switches()) {
      List<ChoiceMetadata> without =
          node.values().stream().map(values -> without(values, schema)).toList();
      switches.add(new SwitchMetadata(node, without));
    }
    List<SensorMetadata> sensors = new ArrayList<>();
    for (EnrichedSensor node : enrichment.sensors()) {
      SensorSchemas schemas = node.schemas();
      sensors.add(
          new SensorMetadata(
              node,
              new SensorSchemas(
                  without(schemas.enter(), schema), without(schemas.exit(), schema))));
    }
    String name = "Remove the schema " + schema;
    List<TextEdit> changes = new ArrayList<>(all(name, switches, sensors).changes());
    // Switches with the same metadata (USE) have the same levels, which change once.
    Set<DocumentElement> done = Collections.newSetFromMap(new IdentityHashMap<>());
    enrichment.switches().forEach(node -> changes.addAll(levelsWithout(node, schema, done)));
    return new Edit(name, changes);
  }

  private List<TextEdit> levelsWithout(
      EnrichedSwitch node, String schema, Set<DocumentElement> done) {
    QualityEdits qualities = new QualityEdits(document);
    List<TextEdit> changes = new ArrayList<>();
    for (EnrichedField field : node.fields()) {
      for (int i = 0; i < field.levels().size(); i++) {
        ChoiceMetadata before = field.levels().get(i).metadata();
        ChoiceMetadata wanted = before.with(without(before.schemas(), schema));
        if (done.add(field.levels().get(i).element())) {
          changes.addAll(qualities.described(node, field, i, wanted));
        }
      }
    }
    return changes;
  }

  /**
   * Returns the metadata of a choice without a schema; a choice that belonged to no other schema
   * loses all its metadata, as when a cell of the table is cleared.
   */
  private static ChoiceMetadata without(ChoiceMetadata values, String schema) {
    List<String> rest = without(values.schemas(), schema);
    boolean last = rest.isEmpty() && !values.schemas().isEmpty();
    return last ? ChoiceMetadata.NONE : values.with(rest);
  }

  private static List<String> without(List<String> schemas, String schema) {
    return schemas.stream().filter(each -> !each.equals(schema)).toList();
  }

  private void wellFormed() {
    document
        .fault()
        .ifPresent(
            fault -> {
              throw new EditRejectedException(
                  fault.location()
                      + ": "
                      + fault.message()
                      + "; correct it in the source view first");
            });
  }
}
