package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;

/** The text directly within an element, gathered piece by piece, and where it begins. */
final class GatheredText {
  private final StringBuilder text = new StringBuilder(0);
  private @Nullable Location start;
  private int offset;

  /**
   * Adds a piece.
   *
   * @param at where its first character stands that is no white space; null for white space only,
   *     or when the text has begun already
   */
  void add(String piece, @Nullable Location at, int offsetOfIt) {
    text.append(piece);
    if (start == null && at != null) {
      start = at;
      offset = offsetOfIt;
    }
  }

  /** Whether there is more than white space. */
  boolean begun() {
    return start != null;
  }

  /** All of it, white space around it included. */
  String text() {
    return text.toString();
  }

  /** Where the first character stands that is no white space; null if there is none. */
  @Nullable Location start() {
    return start;
  }

  /** The offset of the same in its file. */
  int offset() {
    return offset;
  }
}
