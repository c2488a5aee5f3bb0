package org.selectiverenderer.document.file;

import java.io.IOException;

/** A file is not what was opened or saved last: somebody else has written it. */
public final class FileChanged extends IOException {
  private static final long serialVersionUID = 1L;

  FileChanged(String sentence) {
    super(sentence);
  }
}
