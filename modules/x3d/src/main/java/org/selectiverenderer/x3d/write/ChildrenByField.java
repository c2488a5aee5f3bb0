package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Place;
import org.selectiverenderer.x3d.write.SceneItem.Words;

/**
 * The content of a node grouped by fields: XML may mix the nodes of several fields, while VRML and
 * JSON name each field once. A comment is grouped with the item that follows it.
 *
 * @param fields nodes and comments by field; fields that define names precede those that USE them
 * @param statements the statements, which are in no field
 * @param rest the comments after all other items
 */
record ChildrenByField(
    Map<Place, List<SceneItem>> fields, List<SceneItem> statements, List<SceneItem> rest) {

  static ChildrenByField of(Element element) {
    Map<Place, List<SceneItem>> fields = new LinkedHashMap<>();
    List<SceneItem> statements = new ArrayList<>();
    List<SceneItem> words = new ArrayList<>();
    Place last = null;
    boolean mixed = false;
    for (SceneItem item : element.items()) {
      if (item instanceof Words) {
        words.add(item);
        continue;
      }
      Element child = (Element) item;
      Place place = new Place(child.place().name(), child.place().multiple(), true);
      if (child.node()) {
        mixed |= !place.equals(last) && fields.containsKey(place);
        last = place;
      }
      List<SceneItem> into =
          child.node() ? fields.computeIfAbsent(place, key -> new ArrayList<>()) : statements;
      into.addAll(words);
      into.add(child);
      words.clear();
    }
    return new ChildrenByField(mixed ? sorted(fields) : fields, statements, words);
  }

  /** Sorts fields topologically, each before those that USE its names, as far as possible. */
  private static Map<Place, List<SceneItem>> sorted(Map<Place, List<SceneItem>> fields) {
    Map<Place, List<SceneItem>> left = new LinkedHashMap<>(fields);
    Map<Place, List<SceneItem>> sorted = new LinkedHashMap<>();
    while (!left.isEmpty()) {
      Place next = left.keySet().iterator().next();
      for (Place candidate : left.keySet()) {
        Set<String> used = new HashSet<>();
        left.get(candidate).forEach(item -> names(item, false, used));
        Set<String> defined = new HashSet<>();
        for (Map.Entry<Place, List<SceneItem>> other : left.entrySet()) {
          if (!other.getKey().equals(candidate)) {
            other.getValue().forEach(item -> names(item, true, defined));
          }
        }
        used.retainAll(defined);
        if (used.isEmpty()) {
          next = candidate;
          break;
        }
      }
      sorted.put(next, left.get(next));
      left.remove(next);
    }
    return sorted;
  }

  private static void names(SceneItem item, boolean defined, Set<String> into) {
    if (item instanceof Element element) {
      String name = defined ? element.def() : element.use();
      if (!name.isEmpty()) {
        into.add(name);
      }
      element.items().forEach(inner -> names(inner, defined, into));
    }
  }
}
