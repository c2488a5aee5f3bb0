package org.selectiverenderer.polygon;

import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Counts the polygons shown for one choice of versions. The count of each graph node is computed
 * once, however many instances it has.
 */
final class PolygonCounter {
  private final Map<? extends ChoiceKey, Integer> choices;
  private final Map<CountGraphNode, Long> known = new IdentityHashMap<>();

  /**
   * @param choices the shown version of each versioned object
   */
  PolygonCounter(Map<? extends ChoiceKey, Integer> choices) {
    this.choices = choices;
  }

  /** Returns the polygons of one instance of a graph node. */
  long of(CountGraphNode item) {
    if (!item.varies) {
      return item.polygons;
    }
    Long counted = known.get(item);
    if (counted == null) {
      Integer choice = choices.get(item);
      counted = 0L;
      for (CountGraphNode child : item.shown(choice == null ? item.whichChoice() : choice)) {
        counted = CountGraphNode.plus(counted, of(child));
      }
      known.put(item, counted);
    }
    return counted;
  }
}
