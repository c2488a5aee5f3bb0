package org.selectiverenderer.authoring.structure;

import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A position among the children of an element.
 *
 * @param index index of the child before which it is, from 0; the number of children for the end
 */
public record ChildPosition(DocumentElement parent, int index) {
  /** Returns the position after all children of an element. */
  public static ChildPosition last(DocumentElement parent) {
    return new ChildPosition(parent, parent.children().size());
  }

  /**
   * Returns the position after an element.
   *
   * @throws IllegalArgumentException if the element is the root
   */
  public static ChildPosition after(DocumentElement element) {
    DocumentElement parent =
        element
            .parent()
            .orElseThrow(() -> new IllegalArgumentException(element + " has no siblings"));
    return new ChildPosition(parent, parent.children().indexOf(element) + 1);
  }
}
