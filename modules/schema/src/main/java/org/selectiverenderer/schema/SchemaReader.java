package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.schema.SchemaField.Owner;
import org.selectiverenderer.schema.SchemaProblem.Kind;

/**
 * Reads the schema fields of the thesis from the metadata of a node. The layout may vary: spaces
 * around names and values, several values in one MetadataString or several MetadataStrings of one
 * name, nested sets, and a MetadataString without a set around it. Metadata without any schema
 * field serves another purpose and yields neither a result nor a problem.
 */
public final class SchemaReader {
  private final Consumer<SchemaProblem> problems;

  /** Creates a reader that reports each problem as it is found. */
  public SchemaReader(Consumer<SchemaProblem> problems) {
    this.problems = problems;
  }

  /**
   * Reads the schemas of an area from the metadata of its ProximitySensor (thesis Figs 42, 47, 77).
   *
   * @return empty if the metadata has no schema field of areas
   */
  public Optional<SensorSchemas> sensor(MetadataNode metadata) {
    SchemaMetadata words = SchemaMetadata.of(metadata);
    misplaced(words, Owner.CHOICE, "describes a version of an object, not an area");
    if (!words.hasAny(Owner.SENSOR)) {
      return Optional.empty();
    }
    List<String> enter = schemas(words, SchemaField.ENTER_TIME_SCHEMA);
    List<String> exit = schemas(words, SchemaField.EXIT_TIME_SCHEMA);
    return Optional.of(new SensorSchemas(enter, exit));
  }

  /**
   * Reads the schemas of an object's versions from the metadata of its Switch (thesis Figs 43, 52,
   * 78). Metadata without a set for each choice describes the first choice.
   *
   * @param children the number of children of the Switch; sets beyond it are ignored, since a
   *     choice without a child would hide the object
   * @return empty if the metadata has no schema field of choices
   */
  public Optional<SwitchSchemas> switchNode(MetadataNode metadata, int children) {
    SchemaMetadata words = SchemaMetadata.of(metadata);
    misplaced(words, Owner.SENSOR, "describes an area, not an object");
    if (!words.hasAny(Owner.CHOICE)) {
      return Optional.empty();
    }
    List<? extends MetadataNode> sets =
        metadata.children().stream().filter(MetadataNode::isSet).toList();
    if (sets.isEmpty()) {
      sets = List.of(metadata);
    } else {
      misplaced(
          SchemaMetadata.ofStringsIn(metadata),
          Owner.CHOICE,
          "is beside the MetadataSets of the choices, not inside one of them");
    }
    compare(metadata, sets, children);
    VersionMetadataReader reader = new VersionMetadataReader(problems);
    boolean shown =
        sets.stream().anyMatch(set -> SchemaMetadata.of(set).has(SchemaField.SCHEMA_BELONGINESS));
    List<VersionMetadata> choices = new ArrayList<>();
    for (int i = 0; i < Math.min(sets.size(), children); i++) {
      choices.add(reader.read(i, sets.get(i), shown));
    }
    return choices.isEmpty()
        ? Optional.empty()
        : Optional.of(new SwitchSchemas(choices, quality(sets)));
  }

  /**
   * Reads the qualities of an object that are values of fields: the MetadataSet {@value
   * FieldQuality#SET} in the field {@code metadata} of the metadata of its Switch. Members of the
   * metadata's {@code value} would be taken for choices by the loops of the thesis.
   *
   * @param metadata the metadata of a Switch
   */
  public List<FieldQuality> fieldQualities(MetadataNode metadata) {
    return new FieldQualityReader(problems).read(metadata);
  }

  /** Returns what the versions differ in: what the first set that names a quality says. */
  private Quality quality(List<? extends MetadataNode> sets) {
    FieldQualityReader reader = new FieldQualityReader(problems);
    Optional<Quality> first = Optional.empty();
    for (MetadataNode set : sets) {
      Optional<Quality> named = reader.named(set);
      if (named.isPresent() && first.isPresent() && !named.equals(first)) {
        problems.accept(
            new SchemaProblem(
                Kind.SEVERAL_QUALITIES,
                "the versions of a Switch differ in one quality, here %s; %s is ignored"
                    .formatted(first.get().spelling(), named.get().spelling()),
                set));
      }
      first = first.or(() -> named);
    }
    return first.orElse(Quality.POLYGONS);
  }

  private List<String> schemas(SchemaMetadata words, SchemaField field) {
    List<String> schemas = words.values(field);
    if (schemas.isEmpty() && words.has(field)) {
      problems.accept(
          new SchemaProblem(
              Kind.NO_SCHEMA,
              field.spelling() + " names no schema; it is ignored",
              words.source(field)));
    }
    return schemas;
  }

  private void compare(MetadataNode metadata, List<? extends MetadataNode> sets, int children) {
    String counts =
        count(sets.size(), "MetadataSet", "MetadataSets")
            + " for "
            + count(children, "child", "children")
            + " of the Switch; ";
    if (sets.size() < children) {
      problems.accept(
          new SchemaProblem(
              Kind.FEWER_SETS_THAN_CHOICES,
              counts + "no schema shows the other children",
              metadata));
    }
    for (MetadataNode beyond : sets.subList(Math.min(sets.size(), children), sets.size())) {
      if (SchemaMetadata.of(beyond).hasAny(Owner.CHOICE)) {
        problems.accept(
            new SchemaProblem(Kind.MORE_SETS_THAN_CHOICES, counts + "this one is ignored", beyond));
      }
    }
  }

  private static String count(int number, String one, String many) {
    return number + " " + (number == 1 ? one : many);
  }

  private void misplaced(SchemaMetadata words, Owner owner, String why) {
    for (SchemaField field : SchemaField.values()) {
      if (field.owner() == owner && words.has(field)) {
        problems.accept(
            new SchemaProblem(
                Kind.MISPLACED,
                field.spelling() + " " + why + "; it is ignored",
                words.source(field)));
      }
    }
  }
}
