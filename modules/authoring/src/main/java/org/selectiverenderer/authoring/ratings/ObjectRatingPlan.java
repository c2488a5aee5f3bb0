package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.VersionDegreeMapping;
import org.selectiverenderer.authoring.ratings.RatingPlan.ImpliedSchema;
import org.selectiverenderer.authoring.ratings.RatingPlan.Row;
import org.selectiverenderer.authoring.ratings.Ratings.Mean;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.RatingBand;

/** Computes the metadata that ratings imply for one Switch. */
final class ObjectRatingPlan {
  private final EnrichedSwitch node;
  private final RoomPartSchemaResolver places;

  ObjectRatingPlan(EnrichedSwitch node, RoomPartSchemaResolver places) {
    this.node = node;
    this.places = places;
  }

  Row row(String object, Map<String, Mean> means) {
    Map<String, Integer> shown = new LinkedHashMap<>();
    means.forEach(
        (schema, mean) -> shown.put(schema, RatingScale.version(mean.value(), node.values())));
    boolean steady = shown.values().stream().distinct().count() == 1;
    boolean ofRoom = means.keySet().stream().anyMatch(schema -> !places.isPart(schema));
    List<ImpliedSchema> implied = new ArrayList<>();
    means.forEach(
        (schema, mean) -> {
          // A part of the room in which the same version is shown as in the room needs no metadata.
          boolean needless = steady && ofRoom && places.isPart(schema);
          implied.add(
              new ImpliedSchema(
                  schema, mean, needless ? Optional.empty() : Optional.of(shown.get(schema))));
        });
    return new Row(node, Optional.of(object), implied, choices(node, implied));
  }

  /** Returns the metadata of a Switch without ratings that counts as expected in its room. */
  static Row expected(EnrichedSwitch node, String schema) {
    int last = node.choices().size() - 1;
    List<ChoiceMetadata> choices = new ArrayList<>(node.values());
    choices.set(last, RatingScale.values(last, last + 1).with(List.of(schema)));
    return new Row(node, Optional.empty(), List.of(), choices);
  }

  /**
   * Returns the metadata of the choices; existing metadata of schemas that were not rated stays.
   */
  private static List<ChoiceMetadata> choices(EnrichedSwitch node, List<ImpliedSchema> implied) {
    List<String> rated = implied.stream().map(ImpliedSchema::schema).toList();
    List<ChoiceMetadata> choices = new ArrayList<>();
    for (int i = 0; i < node.choices().size(); i++) {
      int index = i;
      ChoiceMetadata before = node.choices().get(i).values();
      List<String> schemas = new ArrayList<>(before.schemas());
      schemas.removeAll(rated);
      boolean others = !schemas.isEmpty();
      implied.stream()
          .filter(each -> each.choice().filter(choice -> choice == index).isPresent())
          .forEach(each -> schemas.add(each.schema()));
      if (schemas.isEmpty()) {
        choices.add(ChoiceMetadata.NONE);
      } else if (others && before.type().isPresent()) {
        choices.add(before.with(schemas));
      } else {
        ChoiceMetadata values = RatingScale.values(i, node.choices().size()).with(schemas);
        boolean scaled = node.choices().size() > 2 && before.degree().isPresent();
        choices.add(scaled ? values.with(before.degree().get()) : values);
      }
    }
    return choices;
  }

  /** Maps a mean rating to a version of an object (thesis 5.1; 7.2 for more than two versions). */
  private static final class RatingScale {
    private static final double LOWEST = 1;
    private static final double HIGHEST = 6;

    private RatingScale() {}

    /**
     * Returns the version. Of two the bands of the thesis choose: the first for an unexpected
     * object, the last for an expected one and a neutral one. Of more versions it is the one of the
     * nearest degree, where the ratings from 1 to 6 are the degrees from 0 to 1.
     */
    static int version(double mean, List<ChoiceMetadata> versions) {
      if (versions.size() <= 2) {
        return RatingBand.of(mean) == RatingBand.NON_EXPECTANT ? 0 : versions.size() - 1;
      }
      double degree = (mean - LOWEST) / (HIGHEST - LOWEST);
      return VersionDegreeMapping.version(
          new ConsistencyDegree(Math.max(0, Math.min(1, degree))), versions);
    }

    /** Returns the type and degree of a version that ratings imply. */
    static ChoiceMetadata values(int version, int versions) {
      ConsistencyDegree degree = VersionDegreeMapping.degree(version, versions);
      ConsistencyType type =
          version == 0 ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT;
      return ChoiceMetadata.NONE.with(type).with(degree);
    }
  }
}
