package org.selectiverenderer.x3d.source;

/** Replaces what only one encoding allows within a value, such as comments, by blanks. */
@FunctionalInterface
public interface ValueCommentStripper {
  /** Cleans the first characters of a buffer; the offsets of the others are unchanged. */
  void clean(char[] value, int length);
}
