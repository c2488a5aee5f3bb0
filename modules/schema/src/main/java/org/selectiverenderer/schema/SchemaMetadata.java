package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.schema.SchemaField.Owner;

/** The values of the schema fields in a metadata node and its descendants. */
final class SchemaMetadata {
  private final Map<SchemaField, Set<String>> values = new EnumMap<>(SchemaField.class);
  private final Map<SchemaField, MetadataNode> sources = new EnumMap<>(SchemaField.class);

  private SchemaMetadata() {}

  /** Collects the schema fields at any depth. A set that contains itself is read once. */
  static SchemaMetadata of(MetadataNode metadata) {
    SchemaMetadata words = new SchemaMetadata();
    words.collect(metadata, new HashSet<>());
    return words;
  }

  /** Collects the schema fields directly in a set, not in nested sets. */
  static SchemaMetadata ofStringsIn(MetadataNode set) {
    SchemaMetadata words = new SchemaMetadata();
    set.children().stream().filter(child -> !child.isSet()).forEach(words::add);
    return words;
  }

  private void collect(MetadataNode metadata, Set<MetadataNode> seen) {
    if (!seen.add(metadata)) {
      return;
    }
    if (!metadata.isSet()) {
      add(metadata);
    }
    for (MetadataNode child : metadata.children()) {
      collect(child, seen);
    }
  }

  private void add(MetadataNode metadata) {
    SchemaField.of(metadata.name())
        .ifPresent(
            field -> {
              sources.putIfAbsent(field, metadata);
              Set<String> found = values.computeIfAbsent(field, key -> new LinkedHashSet<>());
              metadata.values().stream()
                  .map(String::strip)
                  .filter(value -> !value.isEmpty())
                  .forEach(found::add);
            });
  }

  boolean has(SchemaField field) {
    return sources.containsKey(field);
  }

  boolean hasAny(Owner owner) {
    return sources.keySet().stream().anyMatch(field -> field.owner() == owner);
  }

  /** Returns the values of a field in order, without repetitions and empty values. */
  List<String> values(SchemaField field) {
    return new ArrayList<>(values.getOrDefault(field, Set.of()));
  }

  /** Returns the first metadata node with the field, which must exist. */
  MetadataNode source(SchemaField field) {
    MetadataNode source = sources.get(field);
    if (source == null) {
      throw new IllegalStateException("there is no " + field.spelling());
    }
    return source;
  }
}
