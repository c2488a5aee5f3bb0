package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementLocation;

/**
 * A cursor over elements, either of the file while it is parsed or of a recorded prototype body.
 * The reader of an element reads its attributes first, then calls {@link #next()} until it returns
 * false, and reads each child in the same way.
 */
interface ElementCursor {
  /**
   * Enters the next child of the current element. Returns false if there is none or the file is
   * truncated; the parent is then the current element again, without its attributes.
   */
  boolean next();

  /** Returns whether the file is truncated, so that missing parts are not errors of the scene. */
  default boolean broken() {
    return false;
  }

  /** Returns the element's local name; with its prefix if it is of a foreign namespace. */
  String name();

  /** Returns whether the element is of a foreign namespace, such as an XML signature. */
  default boolean foreign() {
    return name().indexOf(':') >= 0;
  }

  ElementLocation place();

  int attributes();

  /** Returns an attribute's local name; empty if it is of a foreign namespace. */
  String attributeName(int index);

  /** Returns the text of an attribute with its references resolved. */
  String attributeText(int index);

  /** Parses an attribute and reports its errors; null if nothing of it is usable. */
  @Nullable Object attributeValue(int index, FieldType type);

  /** Collects the text directly within the current element with its location. */
  void collectText(ElementTextCollector into);

  /** Records the current element with its content for later reading, and leaves the element. */
  DocumentElement record();

  /** Returns the text of the attribute with a name, or null. */
  default @Nullable String attribute(String name) {
    int index = indexOf(name);
    return index < 0 ? null : attributeText(index);
  }

  /** Returns the index of the attribute with a name, or -1. */
  default int indexOf(String name) {
    for (int i = 0; i < attributes(); i++) {
      if (attributeName(i).equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** Skips the rest of the current element. */
  default void skip() {
    for (int depth = 1; depth > 0; ) {
      depth += next() ? 1 : -1;
    }
  }

  default SourceLocation location() {
    return place().location();
  }
}
