package org.selectiverenderer.authoring.ratings;

import java.util.ArrayList;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits.SensorMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits.SwitchMetadata;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.authoring.ratings.RatingPlan.Row;
import org.selectiverenderer.authoring.ratings.Ratings.Mean;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The metadata that ratings imply for a document, to be reviewed before it is applied. A schema
 * that a sensor activates belongs to a part of a room, all others to rooms; {@link
 * RoomPartSchemaResolver} distinguishes them. An object that people expect is shown by its last
 * version, with few polygons, any other object by its first; the bands of ratings are those of
 * thesis 5.1. The schema of a part of a room is written only if it shows another version than the
 * room's schema; otherwise it would have no effect.
 */
public final class RatingPlan {
  /**
   * The implied metadata for one object and one schema.
   *
   * @param choice the version to be shown; empty where the schema is not written
   */
  public record ImpliedSchema(String schema, Mean mean, Optional<Integer> choice) {}

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
      List<ImpliedSchema> schemas,
      List<ChoiceMetadata> choices) {
    public Row {
      schemas = List.copyOf(schemas);
      choices = List.copyOf(choices);
    }
  }

  private final DocumentEnrichment enrichment;
  private final List<Row> rows;
  private final List<SensorMetadata> sensors;
  private final List<Match> unused;
  private final List<EnrichedSwitch> unrated;

  private RatingPlan(
      DocumentEnrichment enrichment,
      List<Row> rows,
      List<SensorMetadata> sensors,
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
   * @param scale how ratings choose among versions
   */
  public static RatingPlan of(
      DocumentEnrichment enrichment,
      Ratings ratings,
      ObjectNameMatcher matching,
      boolean unratedFollow,
      RatingScale scale) {
    return of(enrichment, ratings, ratings, matching, unratedFollow, scale);
  }

  /**
   * Computes the metadata that ratings imply.
   *
   * @param known ratings that are not written themselves, but tell which rooms the objects of an
   *     area belong to
   */
  public static RatingPlan of(
      DocumentEnrichment enrichment,
      Ratings ratings,
      Ratings known,
      ObjectNameMatcher matching,
      boolean unratedFollow,
      RatingScale scale) {
    RoomPartSchemaResolver places =
        new RoomPartSchemaResolver(enrichment.sensors(), ratings, known);
    Map<String, EnrichedSwitch> switches = enrichment.switchesByName();
    Map<String, Row> rows = new LinkedHashMap<>();
    List<Match> unused = new ArrayList<>();
    for (Match match : matching.matches()) {
      EnrichedSwitch node = match.counts() ? switches.get(match.switchName().orElse("")) : null;
      if (node == null || node.choices().size() < 2 || rows.containsKey(node.name())) {
        unused.add(match);
      } else {
        Map<String, Mean> means = ratings.means().get(match.object());
        rows.put(node.name(), new ObjectRatingPlan(node, places, scale).row(match.object(), means));
      }
    }
    RoomSchemaInference rooms = new RoomSchemaInference(rows.values(), places);
    List<EnrichedSwitch> unrated = new ArrayList<>();
    for (EnrichedSwitch node : enrichment.switches()) {
      if (rows.containsKey(node.name()) || node.enriched() || node.choices().size() < 2) {
        continue;
      }
      Optional<String> room = unratedFollow ? rooms.of(node) : Optional.empty();
      if (room.isPresent()) {
        rows.put(node.name(), ObjectRatingPlan.expected(node, room.get(), scale));
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
  public List<SensorMetadata> sensors() {
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
        .all(
            name,
            rows.stream().map(r -> new SwitchMetadata(r.node(), r.choices())).toList(),
            sensors);
  }

  /**
   * Infers the schema of the room that contains an element: that of the rated objects in the
   * smallest enclosing group with any, if they agree.
   */
  private static final class RoomSchemaInference {
    private final Map<DocumentElement, Set<String>> rooms = new IdentityHashMap<>();

    RoomSchemaInference(Collection<Row> rated, RoomPartSchemaResolver places) {
      for (Row row : rated) {
        Optional<DocumentElement> around = row.node().element().parent();
        while (around.isPresent()) {
          Set<String> schemas = rooms.computeIfAbsent(around.get(), key -> new LinkedHashSet<>());
          row.schemas().stream()
              .map(RatingPlan.ImpliedSchema::schema)
              .filter(schema -> !places.isPart(schema))
              .forEach(schemas::add);
          around = around.get().parent();
        }
      }
    }

    Optional<String> of(EnrichedSwitch node) {
      Optional<DocumentElement> around = node.element().parent();
      while (around.isPresent()) {
        Set<String> schemas = rooms.getOrDefault(around.get(), Set.of());
        if (!schemas.isEmpty()) {
          return schemas.size() == 1 ? schemas.stream().findFirst() : Optional.empty();
        }
        around = around.get().parent();
      }
      return Optional.empty();
    }
  }
}
