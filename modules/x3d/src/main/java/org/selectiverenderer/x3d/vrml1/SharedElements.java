package org.selectiverenderer.x3d.vrml1;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

/** The elements that several others contain, and the names by which these use them again. */
final class SharedElements {
  private final Set<String> authorNames;
  private final Set<String> taken = new HashSet<>();
  private final Map<String, Integer> counts = new HashMap<>();
  private final Map<Object, X3dElement> elements = new HashMap<>();

  /**
   * Creates an empty set.
   *
   * @param authorNames the names in the file, which no element without a name gets
   */
  SharedElements(Set<String> authorNames) {
    this.authorNames = authorNames;
  }

  /** Gives an element its node's name, which further elements of that name get with a number. */
  void name(X3dElement element, Vrml1Node node) {
    node.name()
        .ifPresent(
            name -> element.def(taken.add(name) ? name : next(name, counts.getOrDefault(name, 1))));
  }

  private String next(String name, int last) {
    int number = last;
    String unique;
    do {
      number++;
      unique = name + "_" + number;
    } while (authorNames.contains(unique) || !taken.add(unique));
    counts.put(name, number);
    return unique;
  }

  /**
   * Returns an element, or a use of it if it has been asked for before.
   *
   * @param key what the element is made of
   * @param at the offset of a use
   */
  X3dElement once(Object key, int at, Supplier<X3dElement> maker) {
    X3dElement known = elements.get(key);
    if (known == null) {
      known = maker.get();
      elements.put(key, known);
      return known;
    }
    return use(known, at);
  }

  /** Returns a use of an element, which gets a name if it has none. */
  X3dElement use(X3dElement element, int at) {
    if (element.def() == null) {
      element.def(next(element.name(), counts.getOrDefault(element.name(), 0)));
    }
    return element.use(at);
  }
}
