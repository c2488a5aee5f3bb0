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
 * The metadata that ratings imply for a document, to be reviewed before it is applied. A schema
 * that a sensor activates belongs to a part of a room, all others to rooms; {@link SchemaPlaces}
 * distinguishes them. An object that people expect is shown by its last version, with few polygons,
 * any other object by its first; {@link VersionBands} has the bands of thesis 5.1. The schema of a
 * part of a room is written only if it shows another version than the room's schema; otherwise it
 * would have no effect.
 */
public final class RatingPlan {
  /**
   * The implied metadata for one object and one schema.
   *
   * @param choice the version to be shown; empty where the schema is not written
   */
  public record Implied(String schema, Mean mean, Optional<Integer> choice) {}

  /**
   * The implied metadata for one Switch.
   *
   * @param object the object's name in the table; empty for one without ratings that follows its
   *     room
   * @param schemas the schemas in the order of the table
   * @param choices the metadata of the Switch afterwards
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
   * Computes the metadata that ratings imply.
   *
   * @param unratedFollow whether a Switch without ratings and metadata counts as expected in the
   *     room of the rated objects around it, if these belong to one room
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

  /** Returns the changes of the Switches: first the rated ones in the order of the table. */
  public List<Row> rows() {
    return rows;
  }

  /** Returns the changes of areas: those whose names correspond to a schema. */
  public List<SensorWish> sensors() {
    return sensors;
  }

  /**
   * Returns the objects whose ratings are not used: no Switch, a Switch without versions, or one
   * used already.
   */
  public List<Match> unused() {
    return unused;
  }

  /** Returns the Switches without metadata before and after. */
  public List<EnrichedSwitch> unrated() {
    return unrated;
  }

  /** Returns all changes as one edit. */
  public Edit edit(String name) {
    return new EnrichmentEdits(enrichment)
        .all(name, rows.stream().map(r -> new SwitchWish(r.node(), r.choices())).toList(), sensors);
  }
}
