package org.selectiverenderer.polygon;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A part of the scene whose polygons are counted, such as a room.
 *
 * @param objects the enriched Switches in the scope, each once, in document order
 * @param sensors the graph nodes of all area sensors in the scope, in document order
 */
record CountedRegion(
    String name, CountGraphNode item, List<CountGraphNode> objects, Set<CountGraphNode> sensors) {
  static CountedRegion of(String name, CountGraphNode item) {
    List<CountGraphNode> objects = new ArrayList<>();
    Set<CountGraphNode> sensors = new LinkedHashSet<>();
    collect(item, objects, sensors, new HashSet<>());
    return new CountedRegion(name, item, List.copyOf(objects), sensors);
  }

  private static void collect(
      CountGraphNode item,
      List<CountGraphNode> objects,
      Set<CountGraphNode> sensors,
      Set<CountGraphNode> seen) {
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
