package org.selectiverenderer.polygon.statistics;

import java.util.IdentityHashMap;
import java.util.Map;

/** Counts what is shown for one choice of versions. Each item is counted once, wherever it is. */
final class PolygonCounter {
  private final Map<Item, Integer> choices;
  private final Map<Item, Long> known = new IdentityHashMap<>();

  /**
   * @param choices of the objects in versions
   */
  PolygonCounter(Map<Item, Integer> choices) {
    this.choices = choices;
  }

  /** The polygons of an item in one place. */
  long of(Item item) {
    if (!item.varies) {
      return item.polygons;
    }
    Long counted = known.get(item);
    if (counted == null) {
      Integer choice = choices.get(item);
      counted = 0L;
      for (Item child : item.shown(choice == null ? item.whichChoice() : choice)) {
        counted = Item.plus(counted, of(child));
      }
      known.put(item, counted);
    }
    return counted;
  }
}
