package org.selectiverenderer.browser.scene;

import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.Iterator;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The DEF names of a scene as its file gives them, with the scene's nodes: the scenes of one file
 * share the names, and each has only an array of its own. Unmodifiable.
 */
final class NamesOfFile extends AbstractMap<String, Node> {
  private final Map<String, Integer> places;
  private final Node[] nodes;

  /**
   * @param places the place of each name's node; not to be changed
   * @param nodes the nodes; not to be changed
   */
  NamesOfFile(Map<String, Integer> places, Node[] nodes) {
    this.places = places;
    this.nodes = nodes;
  }

  @Override
  public int size() {
    return places.size();
  }

  @Override
  public boolean containsKey(@Nullable Object name) {
    return places.containsKey(name);
  }

  @Override
  public @Nullable Node get(@Nullable Object name) {
    Integer place = places.get(name);
    return place == null ? null : nodes[place];
  }

  @Override
  public Set<Map.Entry<String, Node>> entrySet() {
    return new AbstractSet<>() {
      @Override
      public int size() {
        return places.size();
      }

      @Override
      public Iterator<Map.Entry<String, Node>> iterator() {
        Iterator<Map.Entry<String, Integer>> all = places.entrySet().iterator();
        return new Iterator<>() {
          @Override
          public boolean hasNext() {
            return all.hasNext();
          }

          @Override
          public Map.Entry<String, Node> next() {
            Map.Entry<String, Integer> next = all.next();
            return Map.entry(next.getKey(), nodes[next.getValue()]);
          }
        };
      }
    };
  }
}
