package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.selectiverenderer.testing.ScreenLockExtension;

/**
 * Runs commands in this process and keeps what the last one printed; tests of commands extend it.
 */
public class CommandTestCase {
  /** Options of a run that shows no window. */
  private static final List<String> NO_WINDOW = List.of("--offscreen", "--viewpoints", "--help");

  private boolean showed;

  /**
   * A window beside that of another process's test would take its keys and clicks. Told of {@code
   * run} alone, where it succeeds.
   */
  @RegisterExtension
  final AfterEachCallback windowsHaveTheScreen =
      test ->
          assertThat(showed && !ScreenLockExtension.held(test))
              .as("shows a window without being annotated @ShowsWindows")
              .isFalse();

  protected final ByteArrayOutputStream out = new ByteArrayOutputStream();
  protected final ByteArrayOutputStream err = new ByteArrayOutputStream();

  /** Runs a command and returns its exit status. */
  public final int execute(String... args) {
    out.reset();
    err.reset();
    int status =
        Main.execute(
            args,
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));
    showed |=
        status == 0 && args[0].equals("run") && Collections.disjoint(List.of(args), NO_WINDOW);
    return status;
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
