package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;

/** Thrown if a file cannot be written; its one-line message names the file, cause and outcome. */
public final class FileWriteException extends IOException {
  private static final long serialVersionUID = 1L;

  /** The cause, in words. */
  private final String reason;

  FileWriteException(Path file, Exception cause, String outcome) {
    this(file, cause, outcome, System.getProperty("os.name", ""));
  }

  /**
   * @param system the name of the operating system, as in {@code os.name}
   */
  FileWriteException(Path file, Exception cause, String outcome, String system) {
    super("%s cannot be written (%s); %s".formatted(file, reason(cause, system), outcome), cause);
    reason = reason(cause, system);
  }

  /** Returns the cause for use in a message: {@code permission denied}, {@code it is a folder}. */
  public String reason() {
    return reason;
  }

  /** Adds the file's name to an exception that lacks it, as the one for a full disk does. */
  public static IOException named(Path file, IOException e) {
    return e instanceof FileSystemException ? e : new IOException(file + ": " + e.getMessage(), e);
  }

  /**
   * Returns an exception that names the file and the cause, also where the file system gives the
   * path alone.
   *
   * @param place what is named where the file system names nothing
   */
  public static IOException explained(Path place, FileSystemException e) {
    String file = e.getFile() == null ? place.toString() : e.getFile();
    String cause =
        e instanceof NoSuchFileException
            ? "does not exist"
            : reason(e, System.getProperty("os.name", ""));
    return new IOException(file + ": " + cause, e);
  }

  private static String reason(Exception e, String system) {
    if (e instanceof AccessDeniedException) {
      return system.toLowerCase(Locale.ROOT).startsWith("windows")
          ? "permission denied, or another program has it open"
          : "permission denied";
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
