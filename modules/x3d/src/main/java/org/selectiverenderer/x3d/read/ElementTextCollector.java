package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;

/** Collects the text directly within an element, and the location of its start. */
final class ElementTextCollector {
  private final StringBuilder text = new StringBuilder(0);
  private @Nullable SourceLocation start;
  private int offset;

  /**
   * Adds a piece.
   *
   * @param at the location of its first non-blank character; null if it is blank or the text has
   *     begun already
   */
  void add(String piece, @Nullable SourceLocation at, int offsetOfIt) {
    text.append(piece);
    if (start == null && at != null) {
      start = at;
      offset = offsetOfIt;
    }
  }

  /** Returns whether the text is not blank. */
  boolean begun() {
    return start != null;
  }

  /** Returns the text with surrounding white space. */
  String text() {
    return text.toString();
  }

  /** Returns the location of the first non-blank character; null if there is none. */
  @Nullable SourceLocation start() {
    return start;
  }

  /** Returns the offset in the file of the first non-blank character. */
  int offset() {
    return offset;
  }
}
