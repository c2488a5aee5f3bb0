package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.Nullable;

/**
 * Owns a value: a field of a node, or the array or image around it. It is told of what scripts
 * change in place.
 */
public interface ValueOwner {
  /**
   * Called before the value changes.
   *
   * @throws org.mozilla.javascript.EcmaError if a script may not change it
   */
  default void beforeChange() {}

  /**
   * Called before one element of an array is set.
   *
   * @param element as {@link org.selectiverenderer.x3d.field.FieldType} represents it
   * @throws org.mozilla.javascript.EcmaError if the field does not accept the element
   */
  default void beforeElement(@Nullable Object element) {}

  /** Called after the value has changed; takes the same short time whatever its size. */
  void changed(FieldValue value);
}
