package org.selectiverenderer.cli;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/**
 * Runs commands in this process and keeps what the last one printed; tests of commands extend it.
 */
public class CommandRun {
  protected final ByteArrayOutputStream out = new ByteArrayOutputStream();
  protected final ByteArrayOutputStream err = new ByteArrayOutputStream();

  /** Runs a command and returns its exit status. */
  public final int execute(String... args) {
    out.reset();
    err.reset();
    return Main.execute(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  protected static String text(ByteArrayOutputStream stream) {
    return stream.toString(StandardCharsets.UTF_8);
  }

  /** What the last command printed on standard output. */
  public final String printed() {
    return text(out);
  }

  /** What the last command printed on standard error. */
  public final String messages() {
    return text(err);
  }
}
