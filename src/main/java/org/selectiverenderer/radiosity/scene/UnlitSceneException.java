package org.selectiverenderer.radiosity.scene;

/** Thrown when a scene cannot be lit; the message is one sentence for its author. */
public final class UnlitSceneException extends Exception {
  private static final long serialVersionUID = 1L;

  private final boolean told;

  public UnlitSceneException(String message) {
    this(message, false);
  }

  private UnlitSceneException(String message, boolean told) {
    super(message);
    this.told = told;
  }

  /**
   * Returns the exception for a file in which the reader found no scene; the reason was already
   * reported as a problem.
   */
  public static UnlitSceneException unread() {
    return new UnlitSceneException("there is no scene in the file", true);
  }

  /** Returns whether the reason was already reported as a problem. */
  public boolean isTold() {
    return told;
  }
}
