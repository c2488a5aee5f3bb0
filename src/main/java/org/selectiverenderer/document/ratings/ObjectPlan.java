package org.selectiverenderer.document.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.document.ratings.RatingPlan.Implied;
import org.selectiverenderer.document.ratings.RatingPlan.Row;
import org.selectiverenderer.document.ratings.Ratings.Mean;

/** Computes the metadata that ratings imply for one Switch. */
final class ObjectPlan {
  private final EnrichedSwitch node;
  private final SchemaPlaces places;

  ObjectPlan(EnrichedSwitch node, SchemaPlaces places) {
    this.node = node;
    this.places = places;
  }

  Row row(String object, Map<String, Mean> means) {
    int versions = node.choices().size();
    Map<String, Integer> shown = new LinkedHashMap<>();
    means.forEach(
        (schema, mean) -> shown.put(schema, VersionBands.version(mean.value(), versions)));
    boolean steady = shown.values().stream().distinct().count() == 1;
    boolean ofRoom = means.keySet().stream().anyMatch(schema -> !places.isPart(schema));
    List<Implied> implied = new ArrayList<>();
    means.forEach(
        (schema, mean) -> {
          // A part of the room in which the same version is shown as in the room needs no metadata.
          boolean needless = steady && ofRoom && places.isPart(schema);
          implied.add(
              new Implied(
                  schema, mean, needless ? Optional.empty() : Optional.of(shown.get(schema))));
        });
    return new Row(node, Optional.of(object), implied, choices(node, implied));
  }

  /** Returns the metadata of a Switch without ratings that counts as expected in its room. */
  static Row expected(EnrichedSwitch node, String schema) {
    int last = node.choices().size() - 1;
    List<ChoiceValues> choices = new ArrayList<>(node.values());
    choices.set(last, VersionBands.values(last, last + 1).with(List.of(schema)));
    return new Row(node, Optional.empty(), List.of(), choices);
  }

  /**
   * Returns the metadata of the choices; existing metadata of schemas that were not rated stays.
   */
  private static List<ChoiceValues> choices(EnrichedSwitch node, List<Implied> implied) {
    List<String> rated = implied.stream().map(Implied::schema).toList();
    List<ChoiceValues> choices = new ArrayList<>();
    for (int i = 0; i < node.choices().size(); i++) {
      int index = i;
      ChoiceValues before = node.choices().get(i).values();
      List<String> schemas = new ArrayList<>(before.schemas());
      schemas.removeAll(rated);
      boolean others = !schemas.isEmpty();
      implied.stream()
          .filter(each -> each.choice().filter(choice -> choice == index).isPresent())
          .forEach(each -> schemas.add(each.schema()));
      if (schemas.isEmpty()) {
        choices.add(ChoiceValues.NONE);
      } else if (others && before.type().isPresent()) {
        choices.add(before.with(schemas));
      } else {
        choices.add(VersionBands.values(i, node.choices().size()).with(schemas));
      }
    }
    return choices;
  }
}
