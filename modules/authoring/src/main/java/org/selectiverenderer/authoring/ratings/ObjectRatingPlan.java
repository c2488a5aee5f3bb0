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
    int versions = node.choices().size();
    Map<String, Integer> shown = new LinkedHashMap<>();
    means.forEach(
        (schema, mean) -> shown.put(schema, RatingBandMapping.version(mean.value(), versions)));
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
    choices.set(last, RatingBandMapping.values(last, last + 1).with(List.of(schema)));
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
        choices.add(RatingBandMapping.values(i, node.choices().size()).with(schemas));
      }
    }
    return choices;
  }

  /** Maps a mean rating to a version of an object (thesis 5.1; 7.2 for more than two versions). */
  private static final class RatingBandMapping {
    private RatingBandMapping() {}

    /**
     * Returns the version: the first for an unexpected object, the last for an expected one. A
     * neutral object is shown like an expected one if there are two versions, else by a version
     * between, a later one for a higher rating.
     */
    static int version(double mean, int versions) {
      return switch (RatingBand.of(mean)) {
        case NON_EXPECTANT -> 0;
        case EXPECTANT -> versions - 1;
        case NEUTRAL ->
            versions == 2
                ? 1
                : Math.min(versions - 2, 1 + (int) Math.floor((mean - 3) * (versions - 2)));
      };
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
