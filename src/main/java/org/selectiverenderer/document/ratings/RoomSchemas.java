package org.selectiverenderer.document.ratings;

import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.document.ratings.RatingPlan.Row;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Infers the schema of the room that contains an element: that of the rated objects in the smallest
 * enclosing group with any, if they agree.
 */
final class RoomSchemas {
  private final Map<DocumentElement, Set<String>> rooms = new IdentityHashMap<>();

  RoomSchemas(Collection<Row> rated, SchemaPlaces places) {
    for (Row row : rated) {
      Optional<DocumentElement> around = row.node().element().parent();
      while (around.isPresent()) {
        Set<String> schemas = rooms.computeIfAbsent(around.get(), key -> new LinkedHashSet<>());
        row.schemas().stream()
            .map(RatingPlan.Implied::schema)
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
