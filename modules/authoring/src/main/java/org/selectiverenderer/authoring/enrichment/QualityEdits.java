package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Creates edits of the qualities of a document's Switches. Each edit is for the document's present
 * state and changes only the words that it is about; one that would change nothing is empty.
 *
 * <p>All throw {@link EditRejectedException}, with a sentence for the author, where the metadata
 * are shared between nodes or leave no room.
 */
public final class QualityEdits {
  private final SceneDocument document;
  private final SourceFormatter layout;
  private final SharedMetadataGuard sharing;

  /** Makes edits for the document's present state. */
  public QualityEdits(SceneDocument document) {
    this.document = document;
    this.layout = document.layout();
    this.sharing = new SharedMetadataGuard(document);
  }

  /** Sets what the versions of a Switch differ in; polygons need no word. */
  public Edit ofVersions(EnrichedSwitch node, Quality wanted) {
    String name =
        "Set the quality of the versions of %s to %s".formatted(node.name(), wanted.spelling());
    if (wanted == node.quality()) {
      return new Edit(name, List.of());
    }
    List<MetadataElement> sets = describedVersions(node);
    List<MetadataElement> words =
        sets.stream()
            .flatMap(set -> EnrichedFieldReader.string(set, EnrichedFieldReader.QUALITY).stream())
            .toList();
    List<TextEdit> changes = new ArrayList<>();
    for (MetadataElement word : words) {
      changes.add(
          wanted == Quality.POLYGONS
              ? removed(word.written())
              : value(word, List.of(wanted.spelling())));
    }
    if (words.isEmpty()) {
      sharing.extensible(sets.get(0).meant());
      changes.add(layout.insertLast(sets.get(0).meant(), List.of(word(node.element(), wanted))));
    }
    return new Edit(name, changes);
  }

  /** Returns the sets of the versions; the one set where it describes the first version alone. */
  private List<MetadataElement> describedVersions(EnrichedSwitch node) {
    Optional<MetadataElement> metadata =
        MetadataElement.of(document, node.element()).filter(found -> node.enriched());
    if (metadata.filter(found -> found.isSet() && !found.shared()).isEmpty()) {
      throw new EditRejectedException(
          "describe a version of %s first, by a degree or a schema".formatted(node.name()));
    }
    List<MetadataElement> sets =
        metadata.get().children().stream().filter(MetadataElement::isSet).toList();
    return sets.isEmpty() ? List.of(metadata.get()) : sets;
  }

  private String word(DocumentElement near, Quality wanted) {
    return "<MetadataString"
        + SourceFormatter.written("containerField", "value", layout.quote(near))
        + SourceFormatter.written("name", EnrichedFieldReader.QUALITY, layout.quote(near))
        + SourceFormatter.written(
            "value", FieldValueFormatter.strings(List.of(wanted.spelling())), '\'')
        + "/>";
  }

  /** Adds a quality to a Switch. */
  public Edit add(EnrichedSwitch node, FieldQuality wanted) {
    requireFree(node, wanted.target());
    return new Edit(
        "Add the quality %s to %s".formatted(wanted.quality().spelling(), node.name()),
        new FieldQualityEdits(document).put(node.element(), List.of(wanted)));
  }

  /** Removes a quality of a Switch, and with the last one the sets that only held it. */
  public Edit remove(EnrichedSwitch node, EnrichedField field) {
    DocumentElement at = field.element();
    while (at.parent().filter(around -> holdsOnly(around)).isPresent()) {
      at = at.parent().get();
    }
    return new Edit(
        "Remove the quality %s of %s".formatted(field.quality().spelling(), node.name()),
        List.of(removed(at)));
  }

  private boolean holdsOnly(DocumentElement set) {
    return set.name().equals("MetadataSet")
        && set.children().size() == 1
        && !document.text(set).contains("<!--");
  }

  /** Sets what the levels of a field quality differ in. */
  public Edit quality(EnrichedField field, Quality wanted) {
    return change(
        "Set the quality of %s to %s".formatted(field.target(), wanted.spelling()),
        field.element(),
        EnrichedFieldReader.QUALITY,
        List.of(wanted.spelling()));
  }

  /** Lets a quality set another field. */
  public Edit target(EnrichedSwitch node, EnrichedField field, FieldReference wanted) {
    if (!wanted.equals(field.target())) {
      requireFree(node, wanted);
    }
    return change(
        "Set %s in place of %s".formatted(wanted, field.target()),
        field.element(),
        EnrichedFieldReader.FIELD,
        List.of(wanted.toString()));
  }

  private static void requireFree(EnrichedSwitch node, FieldReference wanted) {
    if (node.fields().stream().anyMatch(known -> known.target().equals(wanted))) {
      throw new EditRejectedException(
          "%s is set by another quality of %s".formatted(wanted, node.name()));
    }
  }

  /** Sets the value of a level. */
  public Edit value(EnrichedField field, int level, List<String> wanted) {
    own(field.element());
    return change(
        "Set level %d of %s".formatted(level + 1, field.target()),
        field.levels().get(level).element(),
        EnrichedFieldReader.VALUE,
        wanted);
  }

  private Edit change(String name, DocumentElement set, String string, List<String> wanted) {
    MetadataElement found =
        EnrichedFieldReader.string(MetadataElement.at(document, own(set)), string).orElseThrow();
    return new Edit(
        name, found.values().equals(wanted) ? List.of() : List.of(value(found, wanted)));
  }

  private TextEdit value(MetadataElement string, List<String> wanted) {
    sharing.free(own(string.written()));
    boolean strings = string.meant().name().equals("MetadataString");
    return layout.attribute(
        string.meant(),
        "value",
        strings ? FieldValueFormatter.strings(wanted) : String.join(" ", wanted));
  }

  /** Returns an element; rejects one that is a USE, as a change of the original changes others. */
  private DocumentElement own(DocumentElement element) {
    if (element.use().isPresent()) {
      throw new EditRejectedException(
          "%s: this belongs to another node (USE); give this node its own metadata in the source first"
              .formatted(document.location(element.start())));
    }
    return element;
  }

  private TextEdit removed(DocumentElement element) {
    sharing.free(element);
    return layout.remove(element);
  }

  /** Sets consistency and schemas of a level. */
  public Edit metadata(EnrichedSwitch node, EnrichedField field, int level, ChoiceMetadata wanted) {
    EnrichedField.Level before = field.levels().get(level);
    SchemaNameValidator.require(wanted.schemas(), before.metadata().schemas());
    return new Edit(
        "Describe level %d of %s".formatted(level + 1, field.target()),
        described(node, field, level, wanted));
  }

  List<TextEdit> described(
      EnrichedSwitch node, EnrichedField field, int level, ChoiceMetadata wanted) {
    EnrichedField.Level before = field.levels().get(level);
    if (wanted.equals(before.metadata())) {
      return List.of();
    }
    own(field.element());
    MetadataXmlWriter text =
        new MetadataXmlWriter(
            new UniqueNameGenerator(document.tree().orElseThrow()),
            layout.quote(field.element()),
            layout.step(field.element()));
    return new MetadataSetWriter(document, text)
        .changes(
            MetadataElement.at(document, own(before.element())),
            "%s_%s_%d".formatted(node.object(), field.quality().spelling(), level + 1),
            SchemaFieldFormatter.changed(
                SchemaFieldFormatter.of(wanted), SchemaFieldFormatter.of(before.metadata())));
  }

  /** Adds a level with the value of the last one after it. */
  public Edit addLevel(EnrichedField field) {
    sharing.extensible(own(field.element()));
    EnrichedField.Level last = field.levels().get(field.levels().size() - 1);
    VersionMetadata undescribed =
        new VersionMetadata(field.levels().size(), Optional.empty(), Optional.empty(), List.of());
    return new Edit(
        "Add a level to " + field.target(),
        List.of(
            layout.insertAfter(
                last.element(),
                new FieldQualityEdits(document)
                    .level(field.element(), undescribed, last.values()))));
  }

  /** Deletes a level; the last one goes with its quality only. */
  public Edit removeLevel(EnrichedField field, int level) {
    if (field.levels().size() == 1) {
      throw new EditRejectedException(
          field.target() + " needs a level; remove the whole quality instead");
    }
    own(field.element());
    return new Edit(
        "Delete level %d of %s".formatted(level + 1, field.target()),
        List.of(removed(field.levels().get(level).element())));
  }
}
