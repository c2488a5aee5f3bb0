package org.selectiverenderer.authoring.ratings;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.SchemaNameValidator;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.authoring.ratings.Ratings.Mean;

/**
 * Finds what head logs name in a scene: the Switches and ratings of objects, the schemas of areas.
 * A snapshot of the document, immutable.
 */
public final class ViewedObjects {
  private static final String SCENE = "scene";

  private final Map<String, Integer> versions = new HashMap<>();
  private final Map<String, String> ofSensors = new HashMap<>();
  private final Set<String> known = new LinkedHashSet<>();

  /** The object of the table of ratings by the name of its Switch. */
  private final Map<String, String> rated = new HashMap<>();

  private final Ratings ratings;

  /**
   * @param ratings may be empty
   * @param matching of the objects of the ratings
   */
  public ViewedObjects(DocumentEnrichment enrichment, Ratings ratings, ObjectNameMatcher matching) {
    this.ratings = ratings;
    for (EnrichedSwitch node : enrichment.switches()) {
      versions.putIfAbsent(node.name(), node.choices().size());
      node.values().stream().map(ChoiceMetadata::schemas).forEach(known::addAll);
    }
    for (EnrichedSensor sensor : enrichment.sensors()) {
      List<String> enter = sensor.schemas().enter();
      if (!enter.isEmpty()) {
        ofSensors.putIfAbsent(sensor.name(), enter.get(0));
      }
      known.addAll(enter);
      known.addAll(sensor.schemas().exit());
    }
    ratings.means().values().forEach(means -> known.addAll(means.keySet()));
    for (Match match : matching.matches()) {
      if (match.counts()) {
        rated.putIfAbsent(match.switchName().orElse(""), match.object());
      }
    }
  }

  /** Returns a scene's objects where there are no ratings. */
  public static ViewedObjects of(DocumentEnrichment enrichment) {
    return new ViewedObjects(
        enrichment, new Ratings(Map.of()), new ObjectNameMatcher(Set.of(), List.of()));
  }

  /**
   * Returns the schema of an area of the logs: the schema that was active, else that of the sensor
   * with its name, else the known one of the same place ({@code DeskSchema} for {@code DeskProx}),
   * else a new one named after the place.
   *
   * @param schema whether the area was named by an active schema
   */
  public String schema(String area, boolean schema) {
    if (schema) {
      return area;
    }
    String ofSensor = ofSensors.get(area);
    if (ofSensor != null) {
      return ofSensor;
    }
    if (area.equals(SCENE) && known.size() == 1) {
      return known.iterator().next();
    }
    String place = RoomPartSchemaResolver.placeOfSensor(area);
    Optional<String> same =
        known.stream()
            .filter(name -> !place.isEmpty())
            .filter(name -> RoomPartSchemaResolver.placeOfSchema(name).equals(place))
            .findFirst();
    return same.orElseGet(() -> RoomPartSchemaResolver.schemaOfSensor(area));
  }

  /** Returns the mean rating of an object of the logs with a schema; empty for none. */
  public OptionalDouble rating(String object, String schema) {
    String name = rated.get(object);
    Mean mean = name == null ? null : ratings.means().getOrDefault(name, Map.of()).get(schema);
    return mean == null ? OptionalDouble.empty() : OptionalDouble.of(mean.value());
  }

  /** Returns the number of versions of an object; 0 if the scene has no Switch of this name. */
  public int versions(String object) {
    return versions.getOrDefault(object, 0);
  }

  /**
   * Returns ratings in which accepted proposals replace those of the same object and schema. A name
   * that cannot be that of a schema is left out.
   *
   * @param onto the ratings to which the proposals are added
   * @param scale how ratings choose among versions
   */
  public Ratings with(Ratings onto, Collection<GazeProposal> accepted, RatingScale scale) {
    return merged(onto, accepted.stream().filter(GazeProposal::applicable).toList(), scale);
  }

  /**
   * Returns which objects belong to which schemas by the ratings and by all proposals, those that
   * are not clear included. Their values say nothing.
   */
  public Ratings places(Collection<GazeProposal> proposals) {
    return merged(ratings, proposals, RatingScale.LINEAR);
  }

  private Ratings merged(Ratings onto, Collection<GazeProposal> proposals, RatingScale scale) {
    Map<String, Map<String, Mean>> means = new LinkedHashMap<>();
    onto.means().forEach((object, own) -> means.put(object, new LinkedHashMap<>(own)));
    for (GazeProposal proposal : proposals) {
      if (SchemaNameValidator.complaint(proposal.schema()).isEmpty()) {
        String name = rated.getOrDefault(proposal.object(), proposal.object());
        means
            .computeIfAbsent(name, key -> new LinkedHashMap<>())
            .put(
                proposal.schema(),
                new Mean(proposal.equivalentRating(scale), proposal.evidence().participants()));
      }
    }
    return new Ratings(means);
  }
}
