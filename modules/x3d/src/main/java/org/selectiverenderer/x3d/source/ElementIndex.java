package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** An index of the elements by DEF name, and of those of the node types that are edited. */
final class ElementIndex {
  private final Map<String, DocumentElement> given = new HashMap<>();
  private final Map<String, Integer> uses = new HashMap<>();
  private final Map<String, Kind> kinds =
      Map.of("Switch", new Kind(), "ProximitySensor", new Kind());

  /** The nodes of one type, sorted in document order on request. */
  private static final class Kind {
    private final Set<DocumentElement> nodes = new HashSet<>();
    private final Set<DocumentElement> gone = new HashSet<>();
    private List<DocumentElement> sorted = List.of();
    private boolean more;

    void remove(DocumentElement element) {
      if (nodes.remove(element)) {
        gone.add(element);
      }
    }

    /** Adds an element; one that was removed before has its old place, as edits never reorder. */
    void add(DocumentElement element) {
      if (element.use().isEmpty()) {
        nodes.add(element);
        more |= !gone.remove(element);
      }
    }

    List<DocumentElement> sorted() {
      if (more || !gone.isEmpty()) {
        List<DocumentElement> now = new ArrayList<>(nodes);
        now.sort(Comparator.comparingInt(DocumentElement::start));
        sorted = Collections.unmodifiableList(now);
        more = false;
        gone.clear();
      }
      return sorted;
    }
  }

  void add(DocumentElement element) {
    element.visit(this::addOne);
  }

  void remove(DocumentElement element) {
    element.visit(this::removeOne);
  }

  /** Removes the names of the element itself, but not of its descendants. */
  void removeOne(DocumentElement element) {
    element.def().ifPresent(def -> given.remove(def, element));
    element.use().ifPresent(use -> uses.computeIfPresent(use, (key, n) -> n == 1 ? null : n - 1));
    Kind kind = kinds.get(element.name());
    if (kind != null) {
      kind.remove(element);
    }
  }

  void addOne(DocumentElement element) {
    element.def().ifPresent(def -> given.putIfAbsent(def, element));
    element.use().ifPresent(use -> uses.merge(use, 1, Integer::sum));
    Kind kind = kinds.get(element.name());
    if (kind != null) {
      kind.add(element);
    }
  }

  Optional<DocumentElement> find(String def) {
    return Optional.ofNullable(given.get(def));
  }

  boolean used(String def) {
    return uses.containsKey(def);
  }

  /**
   * Returns the nodes of an indexed type in document order; the same list object as long as they
   * are unchanged.
   */
  List<DocumentElement> ofType(String type) {
    Kind kind = kinds.get(type);
    return kind == null ? List.of() : kind.sorted();
  }
}
