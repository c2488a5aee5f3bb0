package org.selectiverenderer.authoring.file;

import java.io.IOException;

/** Thrown when another program has written a file since it was opened or saved last. */
public final class FileChangedException extends IOException {
  private static final long serialVersionUID = 1L;

  FileChangedException(String sentence) {
    super(sentence);
  }
}
