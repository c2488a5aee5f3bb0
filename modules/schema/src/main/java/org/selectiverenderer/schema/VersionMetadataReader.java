package org.selectiverenderer.schema;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.selectiverenderer.schema.SchemaField.Owner;
import org.selectiverenderer.schema.SchemaProblem.Kind;

/** Reads the MetadataSet of one choice of a Switch. */
final class VersionMetadataReader {
  private final Consumer<SchemaProblem> problems;

  VersionMetadataReader(Consumer<SchemaProblem> problems) {
    this.problems = problems;
  }

  /**
   * @param shown whether any choice of the Switch names a schema; a choice with a degree alone is
   *     then a level of a scale, which conditions may show
   */
  VersionMetadata read(int index, MetadataNode set, boolean shown) {
    SchemaMetadata words = SchemaMetadata.of(set);
    if (!words.hasAny(Owner.CHOICE)) {
      return VersionMetadata.undescribed(index); // keeps the index of a choice that no schema shows
    }
    Optional<ConsistencyType> type =
        single(
            words,
            SchemaField.CONSISTENCY_TYPE,
            ConsistencyType::of,
            Kind.UNKNOWN_TYPE,
            "consistent, inconsistent or frame");
    Optional<ConsistencyDegree> degree =
        single(
            words,
            SchemaField.DEGREE_OF_CONSISTENCY,
            ConsistencyDegree::of,
            Kind.UNKNOWN_DEGREE,
            "low, high or a number from 0 to 1");
    List<String> schemas = words.values(SchemaField.SCHEMA_BELONGINESS);
    boolean frame = type.filter(ConsistencyType.FRAME::equals).isPresent();
    boolean level = shown && type.isEmpty() && degree.isPresent();
    if (schemas.isEmpty() && !frame && !level) {
      problems.accept(
          new SchemaProblem(
              Kind.NO_SCHEMA, "the metadata names no schema; nothing activates this choice", set));
    }
    return new VersionMetadata(index, type, degree, schemas);
  }

  private <T> Optional<T> single(
      SchemaMetadata words,
      SchemaField field,
      Function<String, Optional<T>> parser,
      Kind unknown,
      String known) {
    List<String> values = words.values(field);
    if (values.isEmpty()) {
      return Optional.empty();
    }
    if (values.size() > 1) {
      problems.accept(
          new SchemaProblem(
              Kind.SEVERAL_VALUES,
              field.spelling() + " has several values; only the first is used: " + values.get(0),
              words.source(field)));
    }
    Optional<T> value = parser.apply(values.get(0));
    if (value.isEmpty()) {
      problems.accept(
          new SchemaProblem(
              unknown,
              field.spelling()
                  + " must be "
                  + known
                  + ", not \""
                  + values.get(0)
                  + "\"; it is ignored",
              words.source(field)));
    }
    return value;
  }
}
