package org.selectiverenderer.x3d.url;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** Formats exceptions of reading files for messages. */
public final class IoErrorFormatter {
  private IoErrorFormatter() {}

  /** Returns the cause as a predicate that follows the file's name. */
  public static String clause(IOException failure) {
    if (failure instanceof AccessDeniedException) {
      return "cannot be read: no permission";
    }
    if (failure instanceof NoSuchFileException) {
      return "no longer exists";
    }
    String reason =
        failure instanceof FileSystemException file ? file.getReason() : failure.getMessage();
    return reason == null ? "cannot be read" : reason;
  }
}
