package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.ratings.RatingPlan.ImpliedSchema;
import org.selectiverenderer.authoring.ratings.RatingPlan.Row;
import org.selectiverenderer.authoring.ratings.Ratings.Mean;

/** Computes the metadata that ratings imply for one Switch. */
final class ObjectRatingPlan {
  private final EnrichedSwitch node;
  private final RoomPartSchemaResolver places;
  private final RatingScale scale;

  ObjectRatingPlan(EnrichedSwitch node, RoomPartSchemaResolver places, RatingScale scale) {
    this.node = node;
    this.places = places;
    this.scale = scale;
  }

  Row row(String object, Map<String, Mean> means) {
    Map<String, Integer> shown = new LinkedHashMap<>();
    means.forEach((schema, mean) -> shown.put(schema, scale.version(mean.value(), node.values())));
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
    return new Row(node, Optional.of(object), implied, choices(implied));
  }

  /** Returns the metadata of a Switch without ratings that counts as expected in its room. */
  static Row expected(EnrichedSwitch node, String schema, RatingScale scale) {
    int last = node.choices().size() - 1;
    List<ChoiceMetadata> choices = new ArrayList<>(node.values());
    choices.set(last, scale.values(last, node.values()).with(List.of(schema)));
    return new Row(node, Optional.empty(), List.of(), scale.complete(choices));
  }

  /**
   * Returns the metadata of the choices; existing metadata of schemas that were not rated stays.
   */
  private List<ChoiceMetadata> choices(List<ImpliedSchema> implied) {
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
        choices.add(scale.values(i, node.values()).with(schemas));
      }
    }
    return scale.complete(choices);
  }
}
