package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits.SensorMetadata;
import org.selectiverenderer.authoring.ratings.Ratings.Mean;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * Determines which of the rated schemas belong to parts of a room, and the metadata of the sensors
 * that follows. A schema belongs to a part if a sensor activates it on entry, or if a sensor
 * without metadata has a corresponding name: DeskProx is the area of DeskSchema (thesis Fig 77).
 * The exit of such an area activates the schemas of the rooms for which its objects were rated.
 */
final class RoomPartSchemaResolver {
  private static final Pattern SENSOR_WORDS =
      Pattern.compile("(?i)proximity|sensor|prox|area|definition|[^\\p{L}\\p{N}]");
  private static final Pattern SCHEMA_WORDS = Pattern.compile("(?i)schema|[^\\p{L}\\p{N}]");

  private final Set<String> parts = new LinkedHashSet<>();
  private final Map<EnrichedSensor, String> newPlaces = new LinkedHashMap<>();
  private final Ratings known;

  /**
   * @param ratings whose schemas sensors get
   * @param known ratings that tell which objects belong to which schemas, among them those of rooms
   *     that are not written
   */
  RoomPartSchemaResolver(List<EnrichedSensor> sensors, Ratings ratings, Ratings known) {
    this.known = known;
    Set<String> schemas = new LinkedHashSet<>();
    ratings.means().values().forEach(bySchema -> schemas.addAll(bySchema.keySet()));
    Set<String> others = new LinkedHashSet<>();
    known.means().values().forEach(bySchema -> others.addAll(bySchema.keySet()));
    for (EnrichedSensor sensor : sensors) {
      parts.addAll(sensor.schemas().enter());
      if (!sensor.enriched()) {
        String place = placeOfSensor(sensor.name());
        schemas.stream()
            .filter(schema -> !place.isEmpty() && place.equals(placeOfSchema(schema)))
            .findFirst()
            .ifPresent(
                schema -> {
                  parts.add(schema);
                  newPlaces.put(sensor, schema);
                });
        others.stream()
            .filter(schema -> !place.isEmpty() && place.equals(placeOfSchema(schema)))
            .forEach(parts::add);
      }
    }
  }

  /** Returns the place that a sensor's name tells: {@code desk} of {@code DeskProx}. */
  static String placeOfSensor(String sensor) {
    return SENSOR_WORDS.matcher(sensor).replaceAll("").toLowerCase(Locale.ROOT);
  }

  /** Returns a name for the schema of a sensor's place: {@code DeskSchema} for {@code DeskProx}. */
  static String schemaOfSensor(String sensor) {
    String place = SENSOR_WORDS.matcher(sensor).replaceAll("");
    return place.isEmpty()
        ? "SceneSchema"
        : place.substring(0, 1).toUpperCase(Locale.ROOT) + place.substring(1) + "Schema";
  }

  /** Returns the place that a schema's name tells: {@code desk} of {@code DeskSchema}. */
  static String placeOfSchema(String schema) {
    return SCHEMA_WORDS.matcher(schema).replaceAll("").toLowerCase(Locale.ROOT);
  }

  /** Returns whether a schema belongs to a part of a room. */
  boolean isPart(String schema) {
    return parts.contains(schema);
  }

  /** Returns the new metadata of sensors without metadata. */
  List<SensorMetadata> wishes() {
    List<SensorMetadata> wishes = new ArrayList<>();
    newPlaces.forEach(
        (sensor, schema) -> {
          Set<String> rooms = new LinkedHashSet<>();
          for (Map<String, Mean> means : known.means().values()) {
            if (means.containsKey(schema)) {
              means.keySet().stream().filter(other -> !isPart(other)).forEach(rooms::add);
            }
          }
          wishes.add(
              new SensorMetadata(sensor, new SensorSchemas(List.of(schema), List.copyOf(rooms))));
        });
    return wishes;
  }
}
