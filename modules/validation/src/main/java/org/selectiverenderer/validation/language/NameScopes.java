package org.selectiverenderer.validation.language;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The name scopes of a file: one for the scene and one for each prototype (X3D 4.0, 4.4.3 and
 * 4.4.4.3). Names of a scope are not visible outside of it; prototypes are also visible in nested
 * scopes.
 */
final class NameScopes {
  private static final int DEEPEST = 20;

  /** A scope with all its names, complete once the whole file has been read. */
  static final class Scope {
    final @Nullable Scope enclosing;
    final Map<String, List<DocumentElement>> names = new LinkedHashMap<>();
    final Map<String, List<PrototypeDeclaration>> prototypes = new HashMap<>();

    /** Names of nodes of unknown type: nodes of inlined files, and unknown elements. */
    final Set<String> imported = new TreeSet<>();

    Scope(@Nullable Scope enclosing) {
      this.enclosing = enclosing;
    }
  }

  private final FileContext file;
  private final Map<DocumentElement, Integer> order = new IdentityHashMap<>();
  private final Map<DocumentElement, Scope> scopes = new IdentityHashMap<>();
  private final Map<DocumentElement, Scope> inner = new IdentityHashMap<>();

  NameScopes(FileContext file) {
    this.file = file;
    Scope scene = new Scope(null);
    int number = 0;
    for (DocumentElement element : file.document().elements()) {
      order.put(element, number++);
      DocumentElement parent = element.parent().orElse(null);
      Scope outer = parent == null ? scene : inside(parent);
      scopes.put(element, outer);
      declare(element, outer);
      if (element.name().equals("ProtoDeclare")) {
        inner.put(element, new Scope(outer));
      }
    }
  }

  /** Returns the scope of an element's children. */
  private Scope inside(DocumentElement element) {
    Scope own = inner.get(element);
    return own != null ? own : of(element);
  }

  private void declare(DocumentElement element, Scope scope) {
    switch (element.name()) {
      case "ProtoDeclare", "ExternProtoDeclare" ->
          element
              .text("name")
              .ifPresent(
                  name ->
                      scope
                          .prototypes
                          .computeIfAbsent(name.strip(), key -> new ArrayList<>(1))
                          .add(new PrototypeDeclaration(element)));
      case "IMPORT" ->
          element
              .text("AS")
              .or(() -> element.text("importedDEF"))
              .or(() -> element.text("exportedDEF"))
              .ifPresent(scope.imported::add);
      default -> {
        if (!file.knows(element)) {
          // The unknown element is reported already; uses of its DEF name are no further errors.
          element.text("DEF").ifPresent(scope.imported::add);
        }
        if (isNode(element) && element.attribute("USE").isEmpty()) {
          element
              .text("DEF")
              .ifPresent(
                  name ->
                      scope.names.computeIfAbsent(name, key -> new ArrayList<>(1)).add(element));
        }
      }
    }
  }

  FileContext file() {
    return file;
  }

  /** Returns the scope that contains an element. */
  Scope of(DocumentElement element) {
    Scope scope = scopes.get(element);
    if (scope == null) {
      throw new IllegalArgumentException(element + " is not of this file");
    }
    return scope;
  }

  /** Returns whether an element represents a node. */
  boolean isNode(DocumentElement element) {
    return element.name().equals("ProtoInstance")
        || file.catalogue().find(element.name()).isPresent();
  }

  /** Returns whether {@code a} begins before {@code b}. */
  boolean before(DocumentElement a, DocumentElement b) {
    return order.getOrDefault(a, 0) < order.getOrDefault(b, 0);
  }

  /** Returns the node that a USE at an element refers to: the last one of that name before it. */
  Optional<DocumentElement> before(String name, DocumentElement at) {
    List<DocumentElement> all = of(at).names.getOrDefault(name, List.of());
    // The nodes are in document order, and may be many: binary search.
    int low = 0;
    int high = all.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (before(all.get(middle), at)) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low == 0 ? Optional.empty() : Optional.of(all.get(low - 1));
  }

  /**
   * Returns the node that a ROUTE at an element refers to: the last one before it, or else the
   * first one after it.
   */
  Optional<DocumentElement> named(String name, DocumentElement at) {
    return before(name, at)
        .or(() -> of(at).names.getOrDefault(name, List.of()).stream().findFirst());
  }

  /** Returns the prototype that an instance at an element refers to. */
  Optional<PrototypeDeclaration> prototype(String name, DocumentElement at) {
    for (Scope scope = of(at); scope != null; scope = scope.enclosing) {
      List<PrototypeDeclaration> all = scope.prototypes.getOrDefault(name, List.of());
      for (int i = all.size() - 1; i >= 0; i--) {
        if (before(all.get(i).element(), at)) {
          return Optional.of(all.get(i));
        }
      }
    }
    return Optional.empty();
  }

  /** Returns the names of the prototypes visible at an element. */
  Set<String> prototypes(DocumentElement at) {
    Set<String> names = new TreeSet<>();
    for (Scope scope = of(at); scope != null; scope = scope.enclosing) {
      names.addAll(scope.prototypes.keySet());
    }
    return names;
  }

  /**
   * Returns the type of the node that an element represents; for a prototype instance, that of the
   * first node in the prototype's body. Empty where it cannot be determined.
   */
  Optional<NodeType> type(DocumentElement element) {
    return type(element, 0);
  }

  private Optional<NodeType> type(DocumentElement element, int depth) {
    if (!element.name().equals("ProtoInstance") || depth > DEEPEST) {
      return file.catalogue().find(element.name());
    }
    DocumentElement instance =
        element.text("USE").flatMap(name -> before(name, element)).orElse(element);
    return instance
        .text("name")
        .flatMap(name -> prototype(name.strip(), instance))
        .flatMap(found -> found.body().stream().filter(this::isNode).findFirst())
        .flatMap(first -> type(first, depth + 1));
  }

  /**
   * Returns the fields that routes to and from a node may name; empty where they cannot be
   * determined.
   */
  Optional<NodeInterface> fields(DocumentElement node) {
    if (node.name().equals("ProtoInstance")) {
      return node.text("name")
          .flatMap(name -> prototype(name.strip(), node))
          .filter(prototype -> !prototype.external() || !prototype.fields().own().isEmpty())
          .map(PrototypeDeclaration::fields);
    }
    return file.catalogue()
        .find(node.name())
        .map(type -> NodeInterface.of(type.name(), Optional.of(type), node.children()));
  }

  /** Returns whether nodes of a type declare fields of their own, as scripts and shaders do. */
  static boolean hasOwnFields(NodeType type) {
    return type.field("field").isPresent() || type.is("X3DScriptNode") || type.is("Script");
  }
}
