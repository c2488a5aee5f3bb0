package org.selectiverenderer.enricher.overview;

import java.util.Locale;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;

/**
 * Which objects the table shows.
 *
 * @param name part of an object's name, in any case; empty for all
 * @param which of those
 */
record RowFilter(String name, Which which) {
  /** All objects. */
  static final RowFilter NONE = new RowFilter("", Which.ALL);

  /** Objects by how far they are enriched. */
  enum Which {
    ALL("All objects"),
    BARE("Without schemas"),
    FAULTY("With problems");

    private final String label;

    Which(String label) {
      this.label = label;
    }

    @Override
    public String toString() {
      return label;
    }
  }

  boolean shows(EnrichedSwitch node) {
    String wanted = name.strip().toLowerCase(Locale.ROOT);
    boolean named = node.name().toLowerCase(Locale.ROOT).contains(wanted);
    return named
        && switch (which) {
          case ALL -> true;
          case BARE -> node.values().stream().allMatch(values -> values.schemas().isEmpty());
          case FAULTY -> !node.findings().isEmpty();
        };
  }
}
