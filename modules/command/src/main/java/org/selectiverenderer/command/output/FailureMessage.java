package org.selectiverenderer.command.output;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.concurrent.CompletionException;

/** Formats an exception as one line for the user. */
public final class FailureMessage {
  private FailureMessage() {}

  /** Returns the message of an exception in one line. */
  public static String of(Throwable failure) {
    return sentence(failure).strip().replaceAll("\\s*\\R\\s*", "; ");
  }

  private static String sentence(Throwable failure) {
    if (failure instanceof CommandException) {
      return failure.getMessage();
    } else if (failure instanceof StandardOutputException output) {
      return "cannot write to standard output: " + sentence(output.getCause());
    } else if (failure instanceof UncheckedIOException unchecked) {
      return sentence(unchecked.getCause());
    } else if (failure instanceof CompletionException && failure.getCause() != null) {
      return sentence(failure.getCause()); // Of work that several processors share.
    } else if (failure instanceof FileSystemException file) {
      return fileSentence(file);
    } else if (failure instanceof CharacterCodingException) {
      return "a file is not UTF-8 text";
    } else if (failure instanceof IOException && failure.getMessage() != null) {
      String prefix = failure instanceof FileNotFoundException ? "cannot open " : "";
      return prefix + failure.getMessage();
    } else if (failure instanceof OutOfMemoryError) {
      return "out of memory; give it more with SELECTIVE_RENDERER_JAVA_OPTS=-Xmx4g";
    }
    return "internal error, please report it: " + failure;
  }

  private static String fileSentence(FileSystemException failure) {
    String file = failure.getFile();
    if (failure instanceof NoSuchFileException) {
      return "no such file: " + file;
    } else if (failure instanceof AccessDeniedException) {
      return "permission denied: " + file;
    } else if (failure instanceof FileAlreadyExistsException) {
      return "the file exists already: " + file;
    } else if (failure instanceof NotDirectoryException) {
      return "not a folder: " + file;
    }
    return failure.getReason() == null ? "cannot use " + file : file + ": " + failure.getReason();
  }
}
