package org.selectiverenderer.polygon.count;

/** A scope was asked for that the scene does not have; the message is a sentence for the user. */
public final class ScopeException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  ScopeException(String message) {
    super(message);
  }
}
