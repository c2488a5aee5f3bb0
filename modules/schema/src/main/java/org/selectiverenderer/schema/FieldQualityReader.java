package org.selectiverenderer.schema;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.selectiverenderer.schema.SchemaProblem.Kind;

/**
 * Reads the field qualities of an object from the metadata of the metadata of its Switch. They
 * stand there because the loops of Figs 48 and 49 take each member of the metadata's {@code value}
 * for a choice of the Switch.
 */
final class FieldQualityReader {
  private static final String QUALITY = "quality";
  private static final String FIELD = "field";
  private static final String VALUE = "value";

  private final Consumer<SchemaProblem> problems;

  FieldQualityReader(Consumer<SchemaProblem> problems) {
    this.problems = problems;
  }

  List<FieldQuality> read(MetadataNode ofSwitch) {
    List<? extends MetadataNode> sets = sets(ofSwitch);
    if (sets.isEmpty()) {
      return List.of(); // as most objects have none
    }
    List<FieldQuality> qualities = new ArrayList<>();
    Set<FieldReference> taken = new HashSet<>();
    List<VersionMetadata> versions =
        new SchemaReader(unheard -> {})
            .switchNode(ofSwitch, Integer.MAX_VALUE)
            .map(SwitchSchemas::choices)
            .orElse(List.of());
    for (MetadataNode set : sets) {
      Optional<FieldReference> target = target(set);
      Optional<Quality> quality = quality(set);
      if (target.isEmpty() || quality.isEmpty()) {
        continue; // reported
      }
      if (!taken.add(target.get())) {
        report(
            Kind.FIELD_TWICE,
            set,
            "several qualities set " + target.get() + "; only the first one does");
        continue;
      }
      List<FieldLevel> levels = levels(set, versions);
      if (!levels.isEmpty()) {
        qualities.add(new FieldQuality(quality.get(), target.get(), levels));
      }
    }
    return qualities;
  }

  /** Returns the quality that a MetadataString in a set names; a wrong word is reported. */
  Optional<Quality> named(MetadataNode set) {
    Optional<? extends MetadataNode> string = string(set, QUALITY);
    if (string.isEmpty()) {
      return Optional.empty();
    }
    String word = first(string.get());
    Optional<Quality> quality = Quality.of(word);
    if (quality.isEmpty()) {
      report(
          Kind.UNKNOWN_QUALITY,
          string.get(),
          "quality must be " + Quality.spellings() + ", not \"" + word + "\"; it is ignored");
    }
    return quality;
  }

  /** Returns the members of a set of field qualities, wherever in the metadata's metadata it is. */
  private static List<? extends MetadataNode> sets(MetadataNode ofSwitch) {
    return ofSwitch.metadata().stream()
        .flatMap(inner -> Stream.concat(Stream.of(inner), inner.children().stream()))
        .filter(inner -> inner.isSet() && inner.name().strip().equals(FieldQuality.SET))
        .flatMap(inner -> inner.children().stream())
        .filter(MetadataNode::isSet)
        .toList();
  }

  private Optional<FieldReference> target(MetadataNode set) {
    Optional<? extends MetadataNode> string = string(set, FIELD);
    Optional<FieldReference> target = string.map(this::first).flatMap(FieldReference::of);
    if (target.isEmpty()) {
      report(
          Kind.UNKNOWN_FIELD,
          string.<MetadataNode>map(found -> found).orElse(set),
          "a field quality needs a MetadataString named field with a DEF name, a dot and the name"
              + " of a field, such as SofaTexture.url; it is ignored");
    }
    return target;
  }

  private Optional<Quality> quality(MetadataNode set) {
    if (string(set, QUALITY).isEmpty()) {
      report(
          Kind.UNKNOWN_QUALITY,
          set,
          "a field quality needs a MetadataString named quality: "
              + Quality.spellings()
              + "; it is ignored");
    }
    return named(set);
  }

  private List<FieldLevel> levels(MetadataNode set, List<VersionMetadata> versions) {
    List<FieldLevel> levels = new ArrayList<>();
    List<SchemaProblem> silent = new ArrayList<>();
    VersionMetadataReader reader = new VersionMetadataReader(problem -> hold(problem, silent));
    for (MetadataNode level : set.children()) {
      if (level.isSet()) {
        string(level, VALUE)
            .ifPresentOrElse(
                value ->
                    levels.add(
                        new FieldLevel(reader.read(levels.size(), level, false), value.values())),
                () ->
                    report(
                        Kind.NO_VALUE,
                        level,
                        "this level of a field quality has no MetadataString named value; it is"
                            + " ignored"));
      }
    }
    if (levels.isEmpty()) {
      report(Kind.NO_VALUE, set, "this field quality has no levels; it is ignored");
      return levels;
    }
    LevelSchemas schemas = new LevelSchemas(levels);
    if (schemas.own()) {
      silent.forEach(problems);
    } else if (!schemas.follow(versions)) {
      report(
          Kind.NO_SCHEMA,
          set,
          "neither the levels of this field quality nor the versions of the Switch name a schema;"
              + " nothing activates a level");
    }
    return schemas.levels();
  }

  private void hold(SchemaProblem problem, List<SchemaProblem> silent) {
    if (problem.kind() == Kind.NO_SCHEMA) {
      silent.add(problem);
    } else {
      problems.accept(problem);
    }
  }

  private static Optional<? extends MetadataNode> string(MetadataNode set, String name) {
    return set.children().stream()
        .filter(child -> !child.isSet() && child.name().strip().equals(name))
        .findFirst();
  }

  private String first(MetadataNode string) {
    return string.values().stream().findFirst().orElse("").strip();
  }

  private void report(Kind kind, MetadataNode node, String message) {
    problems.accept(new SchemaProblem(kind, message, node));
  }
}
