package org.selectiverenderer.document.file;

import java.io.IOException;

/** Thrown when another program has written a file since it was opened or saved last. */
public final class FileChanged extends IOException {
  private static final long serialVersionUID = 1L;

  FileChanged(String sentence) {
    super(sentence);
  }
}
