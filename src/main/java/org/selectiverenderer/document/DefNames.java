package org.selectiverenderer.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Finds elements by the names that DEF gives them, and those of the node types that are edited. */
final class DefNames {
  private final Map<String, DocumentElement> given = new HashMap<>();
  private final Map<String, Integer> uses = new HashMap<>();
  private final Map<String, Set<DocumentElement>> types =
      Map.of("Switch", new HashSet<>(), "ProximitySensor", new HashSet<>());

  void add(DocumentElement element) {
    element.visit(this::addOne);
  }

  void remove(DocumentElement element) {
    element.visit(this::removeOne);
  }

  /** Forgets the names of the element itself, not of those in it. */
  void removeOne(DocumentElement element) {
    element.def().ifPresent(def -> given.remove(def, element));
    element.use().ifPresent(use -> uses.computeIfPresent(use, (key, n) -> n == 1 ? null : n - 1));
    Set<DocumentElement> others = types.get(element.name());
    if (others != null) {
      others.remove(element);
    }
  }

  void addOne(DocumentElement element) {
    element.def().ifPresent(def -> given.putIfAbsent(def, element));
    element.use().ifPresent(use -> uses.merge(use, 1, Integer::sum));
    Set<DocumentElement> others = types.get(element.name());
    if (others != null) {
      others.add(element);
    }
  }

  Optional<DocumentElement> find(String def) {
    return Optional.ofNullable(given.get(def));
  }

  boolean used(String def) {
    return uses.containsKey(def);
  }

  /** The nodes of a type that is kept account of, in document order. */
  List<DocumentElement> ofType(String type) {
    List<DocumentElement> elements = new ArrayList<>(types.getOrDefault(type, Set.of()));
    elements.removeIf(element -> element.use().isPresent());
    elements.sort(Comparator.comparingInt(DocumentElement::start));
    return elements;
  }
}
