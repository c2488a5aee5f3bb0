package org.selectiverenderer.x3d;

import org.jspecify.annotations.Nullable;

/** A text is not well formed. */
public final class XmlFault extends Exception {
  private static final long serialVersionUID = 1L;

  private final int line;
  private final int column;

  XmlFault(int line, int column, String message, @Nullable Throwable cause) {
    super(message, cause);
    this.line = line;
    this.column = column;
  }

  XmlFault(int line, int column, String message) {
    this(line, column, message, null);
  }

  /** From 1; 0 when the fault is the text as a whole. */
  public int line() {
    return line;
  }

  /** From 1, in characters; 0 when unknown. */
  public int column() {
    return column;
  }

  /** What is wrong, as the first half of a sentence. */
  @Override
  public String getMessage() {
    return String.valueOf(super.getMessage());
  }
}
