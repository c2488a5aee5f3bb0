package org.selectiverenderer.document;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Which names are given by DEF and which are used. */
final class DefNames {
  private final Map<String, DocumentElement> given = new HashMap<>();
  private final Map<String, Integer> uses = new HashMap<>();

  void add(DocumentElement element) {
    element.visit(
        each -> {
          each.def().ifPresent(def -> given.putIfAbsent(def, each));
          each.use().ifPresent(use -> uses.merge(use, 1, Integer::sum));
        });
  }

  void remove(DocumentElement element) {
    element.visit(this::removeOne);
  }

  /** Forgets the names of the element itself, not of those in it. */
  void removeOne(DocumentElement element) {
    element.def().ifPresent(def -> given.remove(def, element));
    element.use().ifPresent(use -> uses.computeIfPresent(use, (key, n) -> n == 1 ? null : n - 1));
  }

  void addOne(DocumentElement element) {
    element.def().ifPresent(def -> given.putIfAbsent(def, element));
    element.use().ifPresent(use -> uses.merge(use, 1, Integer::sum));
  }

  Optional<DocumentElement> find(String def) {
    return Optional.ofNullable(given.get(def));
  }

  boolean used(String def) {
    return uses.containsKey(def);
  }
}
