package org.selectiverenderer.cli.bundle;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.machine.ProgramCommand;

/**
 * Adapts the program to a start from a desktop instead of a terminal: the arguments are only files,
 * and error messages are shown in a window, because standard error is invisible.
 */
public final class DesktopStart {
  /** The environment variable that Linux desktop entries set, whose command lines are complete. */
  private static final String VARIABLE = "SELECTIVE_RENDERER_DESKTOP";

  private final @Nullable String command;
  private final boolean unseen;
  private final HeardOutput heard = new HeardOutput();

  /**
   * @param command {@code run} or {@code enrich}, the command to execute with a file; null where
   *     the arguments contain the command
   */
  DesktopStart(@Nullable String command, Map<String, String> environment) {
    this.command = command;
    this.unseen = command != null || environment.containsKey(VARIABLE);
  }

  /** Detects how this process was started. */
  public static DesktopStart ofProcess() {
    return new DesktopStart(System.getProperty(ProgramCommand.DESKTOP), System.getenv());
  }

  /**
   * Returns the program's arguments: the command is put before a file, and without a file the
   * enricher opens.
   */
  public String[] arguments(String[] given) {
    if (command == null) {
      return given;
    }
    if (given.length == 0) {
      return new String[] {"enrich"};
    }
    return Stream.concat(Stream.of(command), Stream.of(given)).toArray(String[]::new);
  }

  /**
   * Returns the stream for messages: the given one, which is also recorded in memory where it is
   * invisible.
   */
  public OutputStream messages(OutputStream err) {
    return unseen ? heard.before(err) : err;
  }

  /** Returns the message to show when the program ends with a status; empty for none. */
  Optional<String> complaint(int status) {
    return Optional.of(heard.text().strip()).filter(text -> status != 0 && !text.isEmpty());
  }

  /**
   * Shows the error messages of a failed program that were invisible; the window outlives this
   * process.
   */
  public void tell(int status) {
    complaint(status).ifPresent(DesktopStart::show);
  }

  /** Shows a text in a separate process, because this Java process may already be headless. */
  private static void show(String text) {
    try {
      Process window =
          new ProcessBuilder(
                  ProgramCommand.of(DesktopMessage.class.getName(), List.of(), List.of()))
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      try (OutputStream in = window.getOutputStream()) {
        in.write(text.getBytes(StandardCharsets.UTF_8));
      }
    } catch (IOException e) {
      // The text went to standard error too; there is no other place to report it.
    }
  }
}
