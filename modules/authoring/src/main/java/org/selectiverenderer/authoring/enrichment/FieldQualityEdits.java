package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.VersionMetadata;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Reads and writes the field qualities of the Switches of a document. */
public final class FieldQualityEdits {
  private final SceneDocument document;
  private final SourceFormatter layout;
  private final SharedMetadataGuard sharing;

  /** Makes edits for the document's present state. */
  public FieldQualityEdits(SceneDocument document) {
    this.document = document;
    this.layout = document.layout();
    this.sharing = new SharedMetadataGuard(document);
  }

  /** Returns the field qualities of a Switch that can be read. */
  public List<FieldQuality> of(DocumentElement object) {
    return MetadataElement.of(document, object)
        .map(new SchemaReader(unheard -> {})::fieldQualities)
        .orElse(List.of());
  }

  /**
   * Returns the changes that give a Switch qualities; one that sets the same field is replaced, all
   * others stay.
   *
   * @param object the element of the Switch
   * @param wanted levels that name no schema are written without, and follow the versions
   * @throws EditRejectedException if its metadata leave no room for them
   */
  public List<TextEdit> put(DocumentElement object, List<FieldQuality> wanted) {
    QualityXml xml = new QualityXml(layout.quote(object), layout.step(object));
    Optional<MetadataElement> outer = MetadataElement.of(document, object);
    if (outer.isEmpty()) {
      String name = MetadataNames.object(object.def().orElse(object.name()));
      return List.of(
          layout.insertFirst(
              object, xml.set("metadata", name, List.of(xml.qualities("metadata", wanted)))));
    }
    requireOwnSet(outer.get(), object);
    Optional<MetadataElement> inner = outer.get().metadata();
    if (inner.isEmpty()) {
      return List.of(layout.insertFirst(outer.get().meant(), xml.qualities("metadata", wanted)));
    }
    requireOwnSet(inner.get(), object);
    Optional<MetadataElement> known = qualities(inner.get());
    known.ifPresent(set -> requireOwnSet(set, object));
    return known.isEmpty()
        ? List.of(layout.insertLast(inner.get().meant(), xml.qualities("value", wanted)))
        : into(known.get(), wanted, xml);
  }

  /** Returns the lines of a level in a quality's element. */
  List<String> level(DocumentElement quality, VersionMetadata metadata, List<String> values) {
    return new QualityXml(layout.quote(quality), layout.step(quality))
        .level(new FieldLevel(metadata, values));
  }

  /** Returns the set of field qualities of a Switch. */
  static Optional<MetadataElement> known(MetadataElement ofSwitch) {
    return ofSwitch.metadata().flatMap(FieldQualityEdits::qualities);
  }

  private static Optional<MetadataElement> qualities(MetadataElement inner) {
    return named(inner)
        ? Optional.of(inner)
        : inner.children().stream().filter(FieldQualityEdits::named).findFirst();
  }

  private static boolean named(MetadataElement set) {
    return set.isSet() && set.name().strip().equals(FieldQuality.SET);
  }

  private void requireOwnSet(MetadataElement metadata, DocumentElement object) {
    if (metadata.shared() || !metadata.isSet()) {
      throw new EditRejectedException(
          "%s: the metadata of %s %s; give it a MetadataSet of its own in the source first"
              .formatted(
                  document.location(metadata.written().start()),
                  object,
                  metadata.shared() ? "belong to another node (USE)" : "are no MetadataSet"));
    }
    sharing.extensible(metadata.meant());
  }

  private List<TextEdit> into(MetadataElement known, List<FieldQuality> wanted, QualityXml xml) {
    List<TextEdit> changes = new ArrayList<>();
    List<String> added = new ArrayList<>();
    for (FieldQuality quality : wanted) {
      Optional<MetadataElement> before =
          known.children().stream()
              .filter(set -> target(set).filter(quality.target()::equals).isPresent())
              .findFirst();
      if (before.isPresent()) {
        sharing.free(before.get().written());
        changes.add(layout.replace(before.get().written(), xml.quality(quality)));
      } else {
        added.addAll(xml.quality(quality));
      }
    }
    if (!added.isEmpty()) {
      changes.add(layout.insertLast(known.meant(), added));
    }
    return changes;
  }

  private static Optional<FieldReference> target(MetadataElement set) {
    return set.children().stream()
        .filter(child -> !child.isSet() && child.name().strip().equals("field"))
        .flatMap(child -> child.values().stream())
        .findFirst()
        .flatMap(FieldReference::of);
  }

  /** Writes field qualities as lines of XML. */
  private record QualityXml(char quote, String step) {
    List<String> qualities(String field, List<FieldQuality> qualities) {
      return set(field, FieldQuality.SET, qualities.stream().map(this::quality).toList());
    }

    List<String> quality(FieldQuality quality) {
      List<List<String>> content = new ArrayList<>();
      content.add(string("quality", List.of(quality.quality().spelling())));
      content.add(string("field", List.of(quality.target().toString())));
      quality.levels().forEach(level -> content.add(level(level)));
      return set("value", quality.quality().spelling(), content);
    }

    private List<String> level(FieldLevel level) {
      List<List<String>> content = new ArrayList<>();
      level
          .metadata()
          .type()
          .map(ConsistencyType::spelling)
          .ifPresent(
              word -> content.add(string(SchemaField.CONSISTENCY_TYPE.spelling(), List.of(word))));
      level
          .metadata()
          .degree()
          .map(ConsistencyDegree::spelling)
          .ifPresent(
              word ->
                  content.add(string(SchemaField.DEGREE_OF_CONSISTENCY.spelling(), List.of(word))));
      List<String> schemas = level.metadata().schemas();
      if (!schemas.isEmpty()) {
        content.add(string(SchemaField.SCHEMA_BELONGINESS.spelling(), schemas));
      }
      content.add(string("value", level.values()));
      return set("value", "", content);
    }

    private List<String> string(String name, List<String> words) {
      return List.of(
          "<MetadataString"
              + SourceFormatter.written("containerField", "value", quote)
              + SourceFormatter.written("name", name, quote)
              // Strings of an MFString are in double quotes, which would have to be escaped.
              + SourceFormatter.written("value", FieldValueFormatter.strings(words), '\'')
              + "/>");
    }

    List<String> set(String field, String name, List<List<String>> content) {
      List<String> lines = new ArrayList<>();
      lines.add(
          "<MetadataSet"
              + SourceFormatter.written("containerField", field, quote)
              + (name.isEmpty() ? "" : SourceFormatter.written("name", name, quote))
              + ">");
      content.forEach(part -> part.forEach(line -> lines.add(step + line)));
      lines.add("</MetadataSet>");
      return lines;
    }
  }
}
