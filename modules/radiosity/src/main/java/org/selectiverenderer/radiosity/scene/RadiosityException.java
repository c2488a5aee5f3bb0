package org.selectiverenderer.radiosity.scene;

/** Thrown when a scene cannot be lit; the message is one sentence for its author. */
public final class RadiosityException extends Exception {
  private static final long serialVersionUID = 1L;

  private final boolean told;

  public RadiosityException(String message) {
    this(message, false);
  }

  private RadiosityException(String message, boolean told) {
    super(message);
    this.told = told;
  }

  /**
   * Returns the exception for a file in which the reader found no scene; the reason was already
   * reported as a problem.
   */
  public static RadiosityException unread() {
    return new RadiosityException("there is no scene in the file", true);
  }

  /** Returns whether the reason was already reported as a problem. */
  public boolean isTold() {
    return told;
  }
}
