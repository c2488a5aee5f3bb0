package org.selectiverenderer.command.output;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Locale;

/**
 * Thrown when standard output cannot be written any more. It is unchecked, since {@link
 * java.io.PrintStream} swallows the checked exception and the command would continue without a
 * reader.
 */
public final class StandardOutputException extends UncheckedIOException {
  private static final long serialVersionUID = 1L;

  public StandardOutputException(IOException cause) {
    super(cause);
  }

  /**
   * Returns whether the reader of a pipe has closed it, as {@code head} does, which is not an
   * error. Java gives only the operating system's text (POSIX "Broken pipe", Windows "The pipe is
   * being closed"); another text means another cause, such as a full disk.
   */
  public boolean readerHasGone() {
    String message = getCause().getMessage();
    return message != null && message.toLowerCase(Locale.ROOT).contains("pipe");
  }
}
