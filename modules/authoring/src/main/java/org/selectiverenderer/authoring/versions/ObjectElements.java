package org.selectiverenderer.authoring.versions;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The elements of an object in a scene. */
sealed interface ObjectElements {
  /** Returns the name of the object, after which its files are named. */
  String name();

  /**
   * An object without versions.
   *
   * @param elements the elements that the versions replace, in document order; at least one
   */
  record Whole(String name, List<DocumentElement> elements) implements ObjectElements {}

  /**
   * An object with versions.
   *
   * @param inlines the Inlines of its Switch, version 1 first
   */
  record Versioned(String name, DocumentElement choice, List<DocumentElement> inlines)
      implements ObjectElements {}
}
