package org.selectiverenderer.authoring.versions;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The elements of an object in a scene. */
sealed interface ObjectElements {
  /** Returns the name of the object, after which its files are named. */
  String name();

  /**
   * An object without versions.
   *
   * @param elements the elements that the versions replace, in document order; at least one
   * @param choice the Switch whose only choice the object is, which takes the versions; empty where
   *     a new Switch does
   */
  record Whole(String name, List<DocumentElement> elements, Optional<DocumentElement> choice)
      implements ObjectElements {
    Whole(String name, List<DocumentElement> elements) {
      this(name, elements, Optional.empty());
    }
  }

  /**
   * An object with versions.
   *
   * @param inlines the Inlines of its Switch, version 1 first
   */
  record Versioned(String name, DocumentElement choice, List<DocumentElement> inlines)
      implements ObjectElements {}
}
