package org.selectiverenderer.polygon.count;

import java.util.IdentityHashMap;
import java.util.Map;

/** Counts what is shown for one choice of versions. Each item is counted once, wherever it is. */
final class PolygonCounter {
  private final Map<CountedItem, Integer> choices;
  private final Map<CountedItem, Long> known = new IdentityHashMap<>();

  /**
   * @param choices of the objects in versions
   */
  PolygonCounter(Map<CountedItem, Integer> choices) {
    this.choices = choices;
  }

  /** The polygons of an item in one place. */
  long of(CountedItem item) {
    if (!item.varies) {
      return item.polygons;
    }
    Long counted = known.get(item);
    if (counted == null) {
      Integer choice = choices.get(item);
      counted = 0L;
      for (CountedItem child : item.shown(choice == null ? item.whichChoice() : choice)) {
        counted = CountedItem.plus(counted, of(child));
      }
      known.put(item, counted);
    }
    return counted;
  }
}
