package org.selectiverenderer.x3d;

import org.jspecify.annotations.Nullable;

/** Hears of the elements of a text in document order. Offsets count characters from its start. */
public interface ElementListener {
  /** A start tag; valid only during the call. */
  interface Tag {
    /** The element's name without prefix. */
    String name();

    /** The offset of its {@code <}. */
    int start();

    /** The offset behind its {@code >}. */
    int end();

    /** Whether it ends with {@code />}, so that nothing stands in the element. */
    boolean empty();

    /** From 1. */
    int line();

    /** From 1, in characters. */
    int column();

    /** An attribute's value, references replaced; null when it is not given. */
    @Nullable String attribute(String name);
  }

  void start(Tag tag);

  /**
   * The element begun last ends.
   *
   * @param offset behind its last {@code >}
   */
  void end(int offset);
}
