package org.selectiverenderer.enricher.overview;

import java.util.Locale;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The filter of the table: which objects it shows.
 *
 * @param name part of an object's name, case-insensitive; empty for all
 * @param which further restriction by metadata
 */
record ObjectRowFilter(String name, Which which) {
  /** All objects. */
  static final ObjectRowFilter NONE = new ObjectRowFilter("", Which.ALL);

  /** The restriction by metadata: all objects, those without schemas, those with findings. */
  enum Which {
    ALL("overview.filter.all"),
    BARE("overview.filter.bare"),
    FAULTY("overview.filter.faulty");

    private final String key;

    Which(String key) {
      this.key = key;
    }

    @Override
    public String toString() {
      return Texts.of(key);
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
