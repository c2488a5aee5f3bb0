package org.selectiverenderer.document.ratings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.enrichment.ChoiceValues;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.document.enrichment.Enrichment;
import org.selectiverenderer.document.enrichment.EnrichmentEdits;
import org.selectiverenderer.document.enrichment.EnrichmentEdits.SensorWish;
import org.selectiverenderer.document.enrichment.EnrichmentEdits.SwitchWish;
import org.selectiverenderer.document.ratings.ObjectMatching.Match;
import org.selectiverenderer.document.ratings.Ratings.Mean;

/**
 * What ratings imply for a document, to be reviewed before it is applied. A schema that a sensor
 * activates is one of a part of a room, the others are of rooms; {@link SchemaPlaces} tells them
 * apart. An object that people expect is shown by its last version, with few polygons, any other by
 * its first; {@link VersionBands} has the bands of thesis 5.1. A part of the room is written only
 * where the object is shown by another version there than in the room: its other schemas would have
 * no effect.
 */
public final class RatingPlan {
  /**
   * What is implied for one object and one schema.
   *
   * @param choice the version to be shown; empty where the schema is not written
   */
  public record Implied(String schema, Mean mean, Optional<Integer> choice) {}

  /**
   * What is implied for one Switch.
   *
   * @param object as the table calls it; empty for one that was not rated and follows its room
   * @param schemas in the order of the table
   * @param choices what the Switch says afterwards
   */
  public record Row(
      EnrichedSwitch node,
      Optional<String> object,
      List<Implied> schemas,
      List<ChoiceValues> choices) {
    public Row {
      schemas = List.copyOf(schemas);
      choices = List.copyOf(choices);
    }
  }

  private final Enrichment enrichment;
  private final List<Row> rows;
  private final List<SensorWish> sensors;
  private final List<Match> unused;
  private final List<EnrichedSwitch> unrated;

  private RatingPlan(
      Enrichment enrichment,
      List<Row> rows,
      List<SensorWish> sensors,
      List<Match> unused,
      List<EnrichedSwitch> unrated) {
    this.enrichment = enrichment;
    this.rows = List.copyOf(rows);
    this.sensors = List.copyOf(sensors);
    this.unused = List.copyOf(unused);
    this.unrated = List.copyOf(unrated);
  }

  /**
   * Works out what ratings imply.
   *
   * @param unratedFollow whether a Switch that was not rated and says nothing yet is taken to be as
   *     expected in its room as the rated ones around it are of one room
   */
  public static RatingPlan of(
      Enrichment enrichment, Ratings ratings, ObjectMatching matching, boolean unratedFollow) {
    SchemaPlaces places = new SchemaPlaces(enrichment.sensors(), ratings);
    Map<String, EnrichedSwitch> switches = enrichment.switchesByName();
    Map<String, Row> rows = new LinkedHashMap<>();
    List<Match> unused = new ArrayList<>();
    for (Match match : matching.matches()) {
      EnrichedSwitch node = match.counts() ? switches.get(match.switchName().orElse("")) : null;
      if (node == null || node.choices().size() < 2 || rows.containsKey(node.name())) {
        unused.add(match);
      } else {
        Map<String, Mean> means = ratings.means().get(match.object());
        rows.put(node.name(), new ObjectPlan(node, places).row(match.object(), means));
      }
    }
    RoomSchemas rooms = new RoomSchemas(rows.values(), places);
    List<EnrichedSwitch> unrated = new ArrayList<>();
    for (EnrichedSwitch node : enrichment.switches()) {
      if (rows.containsKey(node.name()) || node.enriched() || node.choices().size() < 2) {
        continue;
      }
      Optional<String> room = unratedFollow ? rooms.of(node) : Optional.empty();
      if (room.isPresent()) {
        rows.put(node.name(), ObjectPlan.expected(node, room.get()));
      } else {
        unrated.add(node);
      }
    }
    return new RatingPlan(
        enrichment, new ArrayList<>(rows.values()), places.wishes(), unused, unrated);
  }

  /** What changes, object by object: first the rated ones in the order of the table. */
  public List<Row> rows() {
    return rows;
  }

  /** What changes of areas: those whose names say which schema they are the place of. */
  public List<SensorWish> sensors() {
    return sensors;
  }

  /** Objects whose ratings are not used: no Switch, one without versions, or one used already. */
  public List<Match> unused() {
    return unused;
  }

  /** Switches of which nothing is said, before or after. */
  public List<EnrichedSwitch> unrated() {
    return unrated;
  }

  /** All of it as one step. */
  public Edit edit(String name) {
    return new EnrichmentEdits(enrichment)
        .all(name, rows.stream().map(r -> new SwitchWish(r.node(), r.choices())).toList(), sensors);
  }
}
