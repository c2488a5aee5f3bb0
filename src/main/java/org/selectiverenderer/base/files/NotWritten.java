package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;

/** A file that could not be written, in one line that names it, says why, and what has become. */
public final class NotWritten extends IOException {
  private static final long serialVersionUID = 1L;

  /** Why, in words. */
  private final String reason;

  NotWritten(Path file, Exception cause, String outcome) {
    super("%s cannot be written (%s); %s".formatted(file, reason(cause), outcome), cause);
    reason = reason(cause);
  }

  /** Why, for a sentence of the caller's: {@code permission denied}, {@code it is a folder}. */
  public String reason() {
    return reason;
  }

  /** A failure with the file's name, which a full disk does not tell. */
  public static IOException named(Path file, IOException e) {
    return e instanceof FileSystemException ? e : new IOException(file + ": " + e.getMessage(), e);
  }

  private static String reason(Exception e) {
    if (e instanceof AccessDeniedException) {
      return "permission denied";
    }
    if (e instanceof FileAlreadyExistsException) {
      return "another program has just made it";
    }
    if (e instanceof FileSystemException file && file.getReason() != null) {
      return file.getReason();
    }
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }
}
