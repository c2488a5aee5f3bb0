package org.selectiverenderer.polygon;

/**
 * Thrown when a requested scope does not exist in the scene; the message is a sentence for the
 * user.
 */
public final class UnknownRegionException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UnknownRegionException(String message) {
    super(message);
  }
}
