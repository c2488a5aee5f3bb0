package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementLocation;

/**
 * Walks through elements: those of the file as it is parsed, or those of a prototype's body that
 * were kept. A reader that has been given an element asks for its attributes first, then calls
 * {@link #next()} until it has returned false, doing the same with every child.
 */
interface ElementCursor {
  /**
   * Enters the next child of the current element. False when there is none, or when the file breaks
   * off: the parent is the current element again, its attributes are gone.
   */
  boolean next();

  /** Whether the file broke off, so that what is missing is no fault of the scene. */
  default boolean broken() {
    return false;
  }

  /** The element's name without prefix; with it where it is of another language's namespace. */
  String name();

  /** Whether the element is of another language, such as a signature: no matter of the scene's. */
  default boolean foreign() {
    return name().indexOf(':') >= 0;
  }

  ElementLocation place();

  int attributes();

  /** An attribute's name without prefix; empty when it belongs to another language's namespace. */
  String attributeName(int index);

  /** An attribute as it is written, references replaced. */
  String attributeText(int index);

  /** An attribute as a value; what is wrong with it is reported. Null when nothing can be used. */
  @Nullable Object attributeValue(int index, FieldType type);

  /** Gathers the text directly within the current element, and where it begins. */
  void collectText(GatheredText into);

  /** The current element with all within it, for walking through it again; leaves the element. */
  DocumentElement record();

  /** The attribute of that name as text, or null. */
  default @Nullable String attribute(String name) {
    int index = indexOf(name);
    return index < 0 ? null : attributeText(index);
  }

  /** The index of the attribute of that name, or -1. */
  default int indexOf(String name) {
    for (int i = 0; i < attributes(); i++) {
      if (attributeName(i).equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** Leaves the current element with all within it. */
  default void skip() {
    for (int depth = 1; depth > 0; ) {
      depth += next() ? 1 : -1;
    }
  }

  default Location location() {
    return place().location();
  }
}
