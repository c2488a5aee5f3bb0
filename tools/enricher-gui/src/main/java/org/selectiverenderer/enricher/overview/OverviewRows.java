package org.selectiverenderer.enricher.overview;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The rows of the table: the objects that its filter accepts, in its sort order. Rows keep their
 * places while cells are edited, so that nothing moves away under the author's mouse.
 */
final class OverviewRows {
  /** Reads the degree in a cell. */
  interface Degrees {
    Optional<ConsistencyDegree> of(EnrichedSwitch node, String schema);
  }

  private final DocumentEnrichment enrichment;
  private final Degrees degrees;
  private final Map<DocumentElement, Integer> places = new IdentityHashMap<>();
  private List<EnrichedSwitch> rows = List.of();

  OverviewRows(DocumentEnrichment enrichment, Degrees degrees) {
    this.enrichment = enrichment;
    this.degrees = degrees;
  }

  /** Filters and sorts all rows again. */
  void arrange(
      List<EnrichedSwitch> objects,
      List<String> columns,
      ObjectRowFilter filter,
      RowSortKey order) {
    List<EnrichedSwitch> shown = new ArrayList<>();
    objects.stream().filter(filter::shows).forEach(shown::add);
    if (order.column() == 0) {
      Comparator<EnrichedSwitch> byName =
          Comparator.comparing(EnrichedSwitch::object, String.CASE_INSENSITIVE_ORDER);
      shown.sort(order.descending() ? byName.reversed() : byName);
    } else if (order.column() > 0 && order.column() <= columns.size()) {
      String schema = columns.get(order.column() - 1);
      // Empty cells come last in both directions, as one sorts to see what is filled.
      Comparator<Double> values =
          order.descending() ? Comparator.reverseOrder() : Comparator.naturalOrder();
      shown.sort(
          Comparator.comparing(
              node -> degrees.of(node, schema).map(ConsistencyDegree::value).orElse(null),
              Comparator.nullsLast(values)));
    }
    rows = shown;
    places.clear();
    for (int i = 0; i < rows.size(); i++) {
      places.put(rows.get(i).element(), i);
    }
  }

  /** Updates the rows in their present order; returns false, without a change, if a row is gone. */
  boolean stay() {
    List<EnrichedSwitch> fresh = new ArrayList<>(rows.size());
    for (EnrichedSwitch row : rows) {
      Optional<EnrichedSwitch> node = enrichment.switchNode(row.element());
      if (node.isEmpty() || node.get().choices().isEmpty()) {
        return false;
      }
      fresh.add(node.get());
    }
    rows = fresh;
    return true;
  }

  int count() {
    return rows.size();
  }

  EnrichedSwitch node(int row) {
    return rows.get(row);
  }

  /** The row of an object or of the object around an element; -1 if it is not shown. */
  int row(DocumentElement element) {
    for (Optional<DocumentElement> at = Optional.of(element); at.isPresent(); ) {
      Integer row = places.get(at.get());
      if (row != null) {
        return row;
      }
      at = at.get().parent();
    }
    return -1;
  }
}
