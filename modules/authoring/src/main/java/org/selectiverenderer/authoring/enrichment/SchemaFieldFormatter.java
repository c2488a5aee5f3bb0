package org.selectiverenderer.authoring.enrichment;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * Converts metadata to string values keyed by schema field, in the order in which the fields are
 * written.
 */
final class SchemaFieldFormatter {
  private SchemaFieldFormatter() {}

  static Map<SchemaField, List<String>> of(ChoiceMetadata choice) {
    Map<SchemaField, List<String>> values = new EnumMap<>(SchemaField.class);
    values.put(
        SchemaField.CONSISTENCY_TYPE,
        choice.type().map(ConsistencyType::spelling).stream().toList());
    values.put(
        SchemaField.DEGREE_OF_CONSISTENCY,
        choice.degree().map(ConsistencyDegree::spelling).stream().toList());
    values.put(SchemaField.SCHEMA_BELONGINESS, choice.schemas());
    return values;
  }

  static Map<SchemaField, List<String>> of(SensorSchemas schemas) {
    Map<SchemaField, List<String>> values = new EnumMap<>(SchemaField.class);
    values.put(SchemaField.ENTER_TIME_SCHEMA, schemas.enter());
    values.put(SchemaField.EXIT_TIME_SCHEMA, schemas.exit());
    return values;
  }

  /** Returns the fields whose values differ and must be written. */
  static Map<SchemaField, List<String>> changed(
      Map<SchemaField, List<String>> wanted, Map<SchemaField, List<String>> before) {
    Map<SchemaField, List<String>> changed = new EnumMap<>(SchemaField.class);
    wanted.forEach(
        (field, values) -> {
          if (!values.equals(before.get(field))) {
            changed.put(field, values);
          }
        });
    return changed;
  }
}
