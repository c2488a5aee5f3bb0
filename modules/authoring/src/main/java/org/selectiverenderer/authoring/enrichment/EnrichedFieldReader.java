package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;

/**
 * Reads the field qualities of a Switch for editing. What the schema reader ignores and reports is
 * left out: it is corrected in the source.
 */
final class EnrichedFieldReader {
  static final String QUALITY = "quality";
  static final String FIELD = "field";
  static final String VALUE = "value";

  private EnrichedFieldReader() {}

  static List<EnrichedField> read(MetadataElement ofSwitch) {
    List<EnrichedField> fields = new ArrayList<>();
    Set<FieldReference> taken = new HashSet<>();
    FieldQualityEdits.known(ofSwitch).stream()
        .flatMap(set -> set.children().stream())
        .filter(MetadataElement::isSet)
        .forEach(
            set -> {
              Optional<FieldReference> target = first(set, FIELD).flatMap(FieldReference::of);
              Optional<Quality> quality = first(set, QUALITY).flatMap(Quality::of);
              List<EnrichedField.Level> levels = levels(set);
              boolean free = target.isPresent() && taken.add(target.get());
              if (free && quality.isPresent() && !levels.isEmpty()) {
                fields.add(new EnrichedField(set.written(), quality.get(), target.get(), levels));
              }
            });
    return fields;
  }

  private static List<EnrichedField.Level> levels(MetadataElement set) {
    List<MetadataElement> sets = set.children().stream().filter(MetadataElement::isSet).toList();
    // Levels have the names of choices: they are read as if the quality were a Switch.
    List<VersionMetadata> choices =
        new SchemaReader(unheard -> {})
            .switchNode(set, sets.size())
            .map(SwitchSchemas::choices)
            .orElse(List.of());
    List<EnrichedField.Level> levels = new ArrayList<>();
    for (int i = 0; i < sets.size(); i++) {
      MetadataElement level = sets.get(i);
      ChoiceMetadata metadata =
          i < choices.size() ? ChoiceMetadata.of(choices.get(i)) : ChoiceMetadata.NONE;
      string(level, VALUE)
          .ifPresent(
              value ->
                  levels.add(new EnrichedField.Level(level.written(), metadata, value.values())));
    }
    return levels;
  }

  /** Returns the MetadataString of a name in a set. */
  static Optional<MetadataElement> string(MetadataElement set, String name) {
    return set.children().stream()
        .filter(child -> !child.isSet() && child.name().strip().equals(name))
        .findFirst();
  }

  private static Optional<String> first(MetadataElement set, String name) {
    return string(set, name).flatMap(found -> found.values().stream().findFirst());
  }
}
