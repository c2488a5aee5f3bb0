package org.selectiverenderer.radiosity.scene;

/** A scene that cannot be lit; the message is a sentence for its author. */
public final class UnlitSceneException extends Exception {
  private static final long serialVersionUID = 1L;

  public UnlitSceneException(String message) {
    super(message);
  }
}
