package org.selectiverenderer.apartment;

import java.io.IOException;

/** Thrown when existing files differ from those that would be written; the message names them. */
public final class DifferingFilesException extends IOException {
  private static final long serialVersionUID = 1L;

  DifferingFilesException(String message) {
    super(message);
  }
}
