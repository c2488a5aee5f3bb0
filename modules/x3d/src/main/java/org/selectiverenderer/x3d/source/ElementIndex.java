package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * An index of the elements by DEF name in each scope, and of those of the node types that are
 * edited.
 */
final class ElementIndex {
  private final Names root = new Names();

  /** The names of prototypes' declarations; empty in most scenes. */
  private final Map<DocumentElement, Names> prototypes = new IdentityHashMap<>();

  private final Map<String, Kind> kinds =
      Map.of(
          "Switch",
          new Kind(),
          "ProximitySensor",
          new Kind(),
          "ProtoDeclare",
          new Kind(),
          "ExternProtoDeclare",
          new Kind(),
          "ProtoInstance",
          new Kind(),
          "ROUTE",
          new Kind());

  /** The names of one scope, and how often each is used. */
  private static final class Names {
    private final Map<String, DocumentElement> given = new HashMap<>();
    private final Map<String, Integer> uses = new HashMap<>();

    boolean isEmpty() {
      return given.isEmpty() && uses.isEmpty();
    }
  }

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
    if (named(element)) {
      DocumentElement scope = ElementScope.of(element);
      Names names = names(scope);
      element.def().ifPresent(def -> names.given.remove(def, element));
      element
          .use()
          .ifPresent(use -> names.uses.computeIfPresent(use, (key, n) -> n == 1 ? null : n - 1));
      if (names.isEmpty()) {
        prototypes.remove(scope);
      }
    }
    Kind kind = kinds.get(element.name());
    if (kind != null) {
      kind.remove(element);
    }
  }

  void addOne(DocumentElement element) {
    if (named(element)) {
      Names names = names(ElementScope.of(element));
      element.def().ifPresent(def -> names.given.putIfAbsent(def, element));
      element.use().ifPresent(use -> names.uses.merge(use, 1, Integer::sum));
    }
    Kind kind = kinds.get(element.name());
    if (kind != null) {
      kind.add(element);
    }
  }

  private static boolean named(DocumentElement element) {
    return element.def().isPresent() || element.use().isPresent();
  }

  private Names names(DocumentElement scope) {
    return scope.parent().isEmpty()
        ? root
        : prototypes.computeIfAbsent(scope, prototype -> new Names());
  }

  /** Returns the node of a name in a scope of {@link ElementScope}. */
  Optional<DocumentElement> find(String def, DocumentElement scope) {
    return Optional.ofNullable(known(scope).given.get(def));
  }

  boolean used(String def, DocumentElement scope) {
    return known(scope).uses.containsKey(def);
  }

  private Names known(DocumentElement scope) {
    return scope.parent().isEmpty() ? root : prototypes.getOrDefault(scope, new Names());
  }

  /** Returns whether a name is given or used in any scope. */
  boolean anywhere(String name) {
    return occurs(root, name)
        || prototypes.values().stream().anyMatch(names -> occurs(names, name));
  }

  private static boolean occurs(Names names, String name) {
    return names.given.containsKey(name) || names.uses.containsKey(name);
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
