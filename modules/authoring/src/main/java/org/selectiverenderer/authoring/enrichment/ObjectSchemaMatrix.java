package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The table of objects by schemas: each cell contains the degree to which the object is consistent
 * with the schema. Cells are read on demand. An edit makes the table outdated.
 */
public final class ObjectSchemaMatrix {
  private final DocumentEnrichment enrichment;
  private final List<EnrichedSwitch> objects;
  private final List<String> schemas;

  /**
   * A filled cell.
   *
   * @param choice index of the version that is shown when the schema is active
   */
  public record Cell(
      int choice, Optional<ConsistencyType> type, Optional<ConsistencyDegree> degree) {}

  /** The row and column of a cell. */
  public record Place(EnrichedSwitch object, String schema) {
    /** Compares elements by identity, because comparing all metadata of nodes would be slow. */
    @Override
    public boolean equals(Object other) {
      return other instanceof Place place
          && place.object.element() == object.element()
          && place.schema.equals(schema);
    }

    @Override
    public int hashCode() {
      return 31 * System.identityHashCode(object.element()) + schema.hashCode();
    }
  }

  /**
   * @param more schemas that get a column although they are not used yet
   */
  public ObjectSchemaMatrix(DocumentEnrichment enrichment, List<String> more) {
    this.enrichment = enrichment;
    this.objects = enrichment.switches().stream().filter(o -> !o.choices().isEmpty()).toList();
    List<String> columns = new ArrayList<>(enrichment.schemas());
    more.stream().filter(schema -> !columns.contains(schema)).forEach(columns::add);
    this.schemas = List.copyOf(columns);
  }

  /** Returns the rows: Switches with children, in document order. */
  public List<EnrichedSwitch> objects() {
    return objects;
  }

  /** Returns the columns. */
  public List<String> schemas() {
    return schemas;
  }

  /**
   * Returns a cell; if several choices belong to the schema the last one counts, as for the
   * controller.
   */
  public Optional<Cell> cell(EnrichedSwitch object, String schema) {
    for (int i = object.choices().size() - 1; i >= 0; i--) {
      ChoiceMetadata values = object.choices().get(i).values();
      if (values.schemas().contains(schema)) {
        return Optional.of(new Cell(i, values.type(), values.degree()));
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the degrees of the object's other qualities in a schema, in the order of the text; a
   * level without a degree has that of its position.
   */
  public Map<Quality, ConsistencyDegree> levels(EnrichedSwitch object, String schema) {
    Map<Quality, ConsistencyDegree> levels = new LinkedHashMap<>();
    for (FieldQuality quality : object.qualities()) {
      Integer level = quality.schemas().choiceBySchema().get(schema);
      if (level != null) {
        int count = quality.levels().size();
        levels.putIfAbsent(
            quality.quality(),
            quality
                .levels()
                .get(level)
                .metadata()
                .degree()
                .orElse(VersionDegreeMapping.degree(level, count)));
      }
    }
    return levels;
  }

  /**
   * Fills cells with a degree: each object's version for that degree becomes a member of the
   * schema.
   */
  public Edit fill(Collection<Place> places, ConsistencyDegree degree) {
    return edit(
        places.size() == 1
            ? "Set " + label(places)
            : "Set %d cells to %s".formatted(places.size(), degree.spelling()),
        same(places, Optional.of(degree)));
  }

  /** Clears cells: the objects do not belong to the schemas any more. */
  public Edit clear(Collection<Place> places) {
    return edit(
        places.size() == 1 ? "Clear " + label(places) : "Clear %d cells".formatted(places.size()),
        same(places, Optional.empty()));
  }

  private static Map<Place, Optional<ConsistencyDegree>> same(
      Collection<Place> places, Optional<ConsistencyDegree> degree) {
    Map<Place, Optional<ConsistencyDegree>> wanted = new LinkedHashMap<>();
    places.forEach(place -> wanted.put(place, degree));
    return wanted;
  }

  private static String label(Collection<Place> places) {
    Place place = places.iterator().next();
    return place.schema() + " of " + place.object().name();
  }

  /** Fills each cell with its own degree; cells without one are cleared. */
  public Edit edit(String name, Map<Place, Optional<ConsistencyDegree>> cells) {
    Map<DocumentElement, EnrichedSwitch> nodes = new LinkedHashMap<>();
    Map<DocumentElement, List<ChoiceMetadata>> wanted = new LinkedHashMap<>();
    cells.forEach(
        (place, degree) -> {
          DocumentElement element = place.object().element();
          nodes.put(element, place.object());
          wanted.merge(
              element,
              put(place.object().values(), place.schema(), degree),
              (before, fresh) -> put(before, place.schema(), degree));
        });
    List<EnrichmentEdits.SwitchMetadata> wishes = new ArrayList<>();
    wanted.forEach(
        (element, values) ->
            wishes.add(new EnrichmentEdits.SwitchMetadata(nodes.get(element), values)));
    return new EnrichmentEdits(enrichment).all(name, wishes, List.of());
  }

  /** Returns choices of which only the one for the degree belongs to a schema. */
  static List<ChoiceMetadata> put(
      List<ChoiceMetadata> choices, String schema, Optional<ConsistencyDegree> degree) {
    int version = degree.map(d -> VersionDegreeMapping.version(d, choices)).orElse(-1);
    List<ChoiceMetadata> put = new ArrayList<>();
    for (int i = 0; i < choices.size(); i++) {
      ChoiceMetadata choice = choices.get(i);
      boolean has = choice.schemas().contains(schema);
      if (i == version && !has) {
        put.add(VersionDegreeMapping.joined(choice, schema, degree.orElseThrow()));
      } else if (i != version && has) {
        List<String> rest = new ArrayList<>(choice.schemas());
        rest.remove(schema);
        put.add(rest.isEmpty() ? ChoiceMetadata.NONE : choice.with(rest));
      } else {
        put.add(choice);
      }
    }
    if (put.stream().allMatch(choice -> choice.schemas().isEmpty())) {
      // Nothing chooses among the levels of a scale any more.
      return put.stream()
          .map(choice -> choice.type().isPresent() ? choice : ChoiceMetadata.NONE)
          .toList();
    }
    return version >= 0 && VersionDegreeMapping.isScale(put)
        ? VersionDegreeMapping.complete(put)
        : put;
  }
}
