package org.selectiverenderer.cli.output;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Locale;

/**
 * Standard output no longer takes data. Unchecked, since {@link java.io.PrintStream} swallows the
 * checked exception and a command would go on working for nobody.
 */
public final class OutputFailure extends UncheckedIOException {
  private static final long serialVersionUID = 1L;

  public OutputFailure(IOException cause) {
    super(cause);
  }

  /**
   * Whether the reader of a pipe has gone, as {@code head} does: no failure, it has what it wanted.
   * Java gives only the operating system's text (POSIX "Broken pipe", Windows "The pipe is being
   * closed"); another text means another cause, such as a full disk.
   */
  public boolean readerHasGone() {
    String message = getCause().getMessage();
    return message != null && message.toLowerCase(Locale.ROOT).contains("pipe");
  }
}
