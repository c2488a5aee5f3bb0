package org.selectiverenderer.x3d.source;

import java.util.function.Consumer;

/**
 * The scope of the DEF names of elements: the file, or one declaration of a prototype, whose names
 * mean nothing outside of it, as those outside mean nothing in it (X3D 4.0, 4.4.4.3). Files that
 * are inlined are scopes of their own too, but no part of the tree.
 */
public final class ElementScope {
  private static final String DECLARATION = "ProtoDeclare";

  private ElementScope() {}

  /**
   * Returns the element that bounds the scope of an element's names: the nearest ProtoDeclare
   * around it, else the root. A ProtoDeclare itself is part of the scope around it.
   */
  public static DocumentElement of(DocumentElement element) {
    DocumentElement at = element;
    while (at.parent().isPresent()) {
      at = at.parent().get();
      if (bounds(at)) {
        return at;
      }
    }
    return at;
  }

  /** Returns whether names are visible from one element to the other. */
  public static boolean shared(DocumentElement one, DocumentElement other) {
    return of(one) == of(other);
  }

  /** Returns whether the content of an element is a scope of its own. */
  static boolean bounds(DocumentElement element) {
    return element.name().equals(DECLARATION);
  }

  /** Visits the elements of the scope that contains an element, in document order. */
  public static void visit(DocumentElement anyInScope, Consumer<DocumentElement> visitor) {
    DocumentElement scope = of(anyInScope);
    if (scope.parent().isEmpty()) {
      visitor.accept(scope);
    }
    for (DocumentElement child : scope.children()) {
      visitWithin(child, visitor);
    }
  }

  /** Visits an element and those of its descendants that are in the same scope. */
  public static void visitWithin(DocumentElement element, Consumer<DocumentElement> visitor) {
    visitor.accept(element);
    if (!bounds(element)) {
      for (DocumentElement child : element.children()) {
        visitWithin(child, visitor);
      }
    }
  }
}
