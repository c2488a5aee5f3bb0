package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates the text changes that set the metadata of Switches and ProximitySensors, for one edit.
 */
final class EnrichedNodeWriter {
  private final SceneDocument document;
  private final SourceFormatter layout;
  private final UniqueNameGenerator names;
  private final SharedMetadataGuard sharing;

  EnrichedNodeWriter(SceneDocument document) {
    this.document = document;
    this.layout = document.layout();
    this.names = new UniqueNameGenerator(document.tree().orElseThrow());
    this.sharing = new SharedMetadataGuard(document);
  }

  private MetadataXmlWriter text(DocumentElement owner) {
    return new MetadataXmlWriter(names, layout.quote(owner), layout.step(near(owner)));
  }

  /** Returns the element that shows the author's indentation inside an element. */
  private static DocumentElement near(DocumentElement owner) {
    return owner.children().isEmpty() ? owner : owner.children().get(0);
  }

  /**
   * @param wanted for each choice in order
   */
  List<TextEdit> changes(EnrichedSwitch node, List<ChoiceMetadata> wanted) {
    if (wanted.equals(node.values())) {
      return List.of();
    }
    MetadataXmlWriter text = text(node.element());
    Optional<MetadataElement> found = MetadataElement.of(document, node.element());
    if (found.isEmpty()) {
      return List.of(layout.insertFirst(node.element(), text.object(node.object(), wanted)));
    }
    MetadataElement metadata = found.get();
    List<MetadataElement> sets =
        metadata.children().stream().filter(MetadataElement::isSet).toList();
    if (wanted.stream().allMatch(ChoiceMetadata::isEmpty) && ours(metadata)) {
      sharing.free(metadata.written());
      return List.of(layout.remove(metadata.written()));
    }
    boolean own = !metadata.shared() && metadata.isSet();
    boolean firstOnly = wanted.subList(1, wanted.size()).stream().allMatch(ChoiceMetadata::isEmpty);
    if (own && sets.isEmpty() && node.enriched() && firstOnly) {
      return set(metadata, text, node, 0, wanted.get(0)); // it describes the first choice only
    }
    boolean beside = node.enriched() && sets.isEmpty();
    boolean occupied = !node.enriched() && !sets.isEmpty();
    if (own && !beside && !occupied) {
      return parts(metadata, sets, text, node, wanted);
    }
    return wrapped(
        metadata, kept -> text.object(node.object(), partLines(text, node, wanted), kept));
  }

  private static List<List<String>> partLines(
      MetadataXmlWriter text, EnrichedSwitch node, List<ChoiceMetadata> wanted) {
    List<List<String>> parts = new ArrayList<>();
    for (int i = 0; i < wanted.size(); i++) {
      parts.add(text.part(node.object(), i, wanted.get(i)));
    }
    return parts;
  }

  private List<TextEdit> parts(
      MetadataElement metadata,
      List<MetadataElement> sets,
      MetadataXmlWriter text,
      EnrichedSwitch node,
      List<ChoiceMetadata> wanted) {
    List<TextEdit> changes = new ArrayList<>();
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < wanted.size(); i++) {
      if (i >= sets.size()) {
        lines.addAll(text.part(node.object(), i, wanted.get(i)));
      } else if (wanted.get(i).equals(node.values().get(i))) {
        continue;
      } else if (sets.get(i).shared()) {
        foreign(sets.get(i));
        sharing.extensible(metadata.meant());
        changes.add(
            layout.replace(sets.get(i).written(), text.part(node.object(), i, wanted.get(i))));
      } else {
        changes.addAll(set(sets.get(i), text, node, i, wanted.get(i)));
      }
    }
    if (!lines.isEmpty()) {
      sharing.extensible(metadata.meant());
      changes.add(layout.insertLast(metadata.meant(), lines));
    }
    return changes;
  }

  /** Adds a MetadataSet for one more choice, if each existing choice has one. */
  List<TextEdit> partAdded(EnrichedSwitch node) {
    Optional<MetadataElement> found = MetadataElement.of(document, node.element());
    if (found.isEmpty() || !node.enriched()) {
      return List.of();
    }
    int size = node.choices().size();
    List<MetadataElement> sets = sets(found.get());
    if (sets.size() < size) {
      return List.of();
    }
    if (sets.size() > size) {
      throw new EditRejectedException(
          "the metadata of %s describes more choices than the Switch has; remove the surplus first"
              .formatted(node.name()));
    }
    sharing.free(found.get().written());
    return List.of(
        layout.insertLast(
            found.get().meant(),
            text(node.element()).part(node.object(), size, ChoiceMetadata.NONE)));
  }

  /** Removes the MetadataSet of a choice; all metadata if the other choices have none. */
  List<TextEdit> partRemoved(EnrichedSwitch node, int index) {
    Optional<MetadataElement> found = MetadataElement.of(document, node.element());
    if (found.isEmpty() || !node.enriched()) {
      return List.of();
    }
    MetadataElement metadata = found.get();
    List<MetadataElement> sets = sets(metadata);
    boolean silent = true;
    for (int i = 0; i < node.choices().size(); i++) {
      silent &= i == index || node.values().get(i).isEmpty();
    }
    if (silent && ours(metadata)) {
      sharing.free(metadata.written());
      return List.of(layout.remove(metadata.written()));
    }
    if (sets.isEmpty() && index > 0 || !sets.isEmpty() && index >= sets.size()) {
      return List.of(); // it does not describe that choice
    }
    if (sets.isEmpty() || metadata.shared()) {
      throw new EditRejectedException(
          "the metadata of %s belongs to several nodes or to its first choice alone; clear the choice first"
              .formatted(node.name()));
    }
    sharing.free(sets.get(index).written());
    return List.of(layout.remove(sets.get(index).written()));
  }

  private static List<MetadataElement> sets(MetadataElement metadata) {
    return metadata.children().stream().filter(MetadataElement::isSet).toList();
  }

  private List<TextEdit> set(
      MetadataElement set,
      MetadataXmlWriter text,
      EnrichedSwitch node,
      int index,
      ChoiceMetadata wanted) {
    Map<SchemaField, List<String>> changed =
        SchemaFieldFormatter.changed(
            SchemaFieldFormatter.of(wanted), SchemaFieldFormatter.of(node.values().get(index)));
    return new MetadataSetWriter(document, text)
        .changes(set, MetadataNames.ofPart(node.object(), index), changed);
  }

  List<TextEdit> changes(EnrichedSensor node, SensorSchemas wanted) {
    Map<SchemaField, List<String>> fields = SchemaFieldFormatter.of(wanted);
    Map<SchemaField, List<String>> changed =
        SchemaFieldFormatter.changed(fields, SchemaFieldFormatter.of(node.schemas()));
    if (changed.isEmpty()) {
      return List.of();
    }
    String name = node.element().def().orElse(node.name());
    MetadataXmlWriter text = text(node.element());
    Optional<MetadataElement> found = MetadataElement.of(document, node.element());
    if (found.isEmpty()) {
      return List.of(layout.insertFirst(node.element(), text.sensor(name, fields, List.of())));
    }
    MetadataElement metadata = found.get();
    if (wanted.enter().isEmpty() && wanted.exit().isEmpty() && ours(metadata)) {
      sharing.free(metadata.written());
      return List.of(layout.remove(metadata.written()));
    }
    if (!metadata.shared() && metadata.isSet()) {
      return new MetadataSetWriter(document, text).changes(metadata, name, changed);
    }
    return wrapped(metadata, kept -> text.sensor(name, fields, kept));
  }

  /** Returns whether metadata is schema metadata and contains nothing else, not even a comment. */
  private boolean ours(MetadataElement metadata) {
    return speaks(metadata) && nothingElse(metadata);
  }

  private static boolean speaks(MetadataElement metadata) {
    return SchemaField.of(metadata.name()).isPresent() && !metadata.isSet()
        || metadata.children().stream().anyMatch(EnrichedNodeWriter::speaks);
  }

  private boolean nothingElse(MetadataElement metadata) {
    if (!metadata.isSet()) {
      return SchemaField.of(metadata.name()).isPresent();
    }
    return !document.text(metadata.meant()).contains("<!--")
        && metadata.meant().children().size() == metadata.children().size()
        && metadata.children().stream().allMatch(this::nothingElse);
  }

  /** Rejects the replacement of a USE reference to metadata that also contains other metadata. */
  private void foreign(MetadataElement shared) {
    if (!ours(shared)) {
      throw new EditRejectedException(
          ("%s: the metadata here belongs to another node (USE) and contains more than "
                      + "schemas; give this")
                  .formatted(document.location(shared.written().start()))
              + " node its own metadata in the source view first");
    }
  }

  /**
   * Replaces metadata that cannot contain schema metadata by a new MetadataSet, into which other
   * metadata is moved.
   */
  private List<TextEdit> wrapped(
      MetadataElement metadata, Function<List<String>, List<String>> block) {
    DocumentElement old = metadata.written();
    if (metadata.shared()) {
      foreign(metadata);
      return List.of(layout.replace(old, block.apply(List.of())));
    }
    sharing.free(old);
    if (ours(metadata)) {
      return List.of(layout.replace(old, block.apply(List.of())));
    }
    return List.of(layout.replace(old, block.apply(inside(old))));
  }

  /**
   * Returns an element's lines as a child of a MetadataSet: only {@code containerField} and the
   * indentation change.
   */
  private List<String> inside(DocumentElement element) {
    String source = document.text(element);
    Optional<SourceAttribute> field = document.tag(element).attribute("containerField");
    if (field.isPresent()) {
      int from = field.get().valueFrom() - element.start();
      int to = field.get().valueTo() - element.start();
      source = source.substring(0, from) + "value" + source.substring(to);
    } else {
      int at = document.tag(element).end() - element.start();
      String added = SourceFormatter.written("containerField", "value", layout.quote(element));
      source = source.substring(0, at) + added + source.substring(at);
    }
    String indentation = layout.indentation(element);
    return source
        .lines()
        .map(line -> line.startsWith(indentation) ? line.substring(indentation.length()) : line)
        .toList();
  }
}
