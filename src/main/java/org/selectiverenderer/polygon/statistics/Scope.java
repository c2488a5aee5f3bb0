package org.selectiverenderer.polygon.statistics;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A part of the scene to be counted.
 *
 * @param objects the enriched Switches in it, each once, in document order
 * @param sensors the items of all areas that stand in it, in document order
 */
record Scope(String name, Item item, List<Item> objects, Set<Item> sensors) {
  static Scope of(String name, Item item) {
    List<Item> objects = new ArrayList<>();
    Set<Item> sensors = new LinkedHashSet<>();
    collect(item, objects, sensors, new HashSet<>());
    return new Scope(name, item, List.copyOf(objects), sensors);
  }

  private static void collect(Item item, List<Item> objects, Set<Item> sensors, Set<Item> seen) {
    if (!seen.add(item)) {
      return;
    }
    if (item.versions.isPresent()) {
      objects.add(item);
    }
    if (item.area.isPresent()) {
      sensors.add(item);
    }
    item.children.forEach(child -> collect(child, objects, sensors, seen));
  }
}
