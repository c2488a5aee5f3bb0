package org.selectiverenderer.render.context;

/** GL cannot be used here; the message is one sentence for the user. */
public final class GlUnavailableException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public GlUnavailableException(String message) {
    super(message);
  }

  public GlUnavailableException(String message, Throwable cause) {
    super(message, cause);
  }
}
