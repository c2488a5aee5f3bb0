package org.selectiverenderer.document.versions;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Where an object stands in a scene. */
sealed interface ObjectElement {
  /** The name of the object, which its files take. */
  String name();

  /**
   * An object without versions.
   *
   * @param elements what its versions take the place of, in document order; at least one
   */
  record Whole(String name, List<DocumentElement> elements) implements ObjectElement {}

  /**
   * An object with versions.
   *
   * @param inlines the Inlines of its Switch, version 1 first
   */
  record Versioned(String name, DocumentElement choice, List<DocumentElement> inlines)
      implements ObjectElement {}
}
