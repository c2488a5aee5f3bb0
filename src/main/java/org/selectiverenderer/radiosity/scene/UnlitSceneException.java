package org.selectiverenderer.radiosity.scene;

/** A scene that cannot be lit; the message is a sentence for its author. */
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

  /** A file in which the reader found no scene: its author was told why as a problem. */
  public static UnlitSceneException unread() {
    return new UnlitSceneException("there is no scene in the file", true);
  }

  /** Whether the author knows already what is wrong. */
  public boolean isTold() {
    return told;
  }
}
