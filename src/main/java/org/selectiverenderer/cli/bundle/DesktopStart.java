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
 * How the program was started: in a terminal, or from a desktop. There files are all that is given,
 * and nobody sees what is said; so what a failure says is shown in a window.
 */
public final class DesktopStart {
  /** Set by Linux's desktop entries, which give the whole command line. */
  private static final String VARIABLE = "SELECTIVE_RENDERER_DESKTOP";

  private final @Nullable String command;
  private final boolean unseen;
  private final HeardOutput heard = new HeardOutput();

  /**
   * @param command {@code run} or {@code enrich}, what is done with a file; null where the
   *     arguments name their command
   */
  DesktopStart(@Nullable String command, Map<String, String> environment) {
    this.command = command;
    this.unseen = command != null || environment.containsKey(VARIABLE);
  }

  /** How this process was started. */
  public static DesktopStart ofProcess() {
    return new DesktopStart(System.getProperty(ProgramCommand.DESKTOP), System.getenv());
  }

  /**
   * The arguments of the program: a file is given to the command, and without one the enricher
   * opens.
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

  /** Where messages go: to the one given, and into memory where nobody sees that one. */
  public OutputStream messages(OutputStream err) {
    return unseen ? heard.before(err) : err;
  }

  /** What is to be shown of a program that ends with this status; empty for nothing. */
  Optional<String> complaint(int status) {
    return Optional.of(heard.text().strip()).filter(text -> status != 0 && !text.isEmpty());
  }

  /** Shows what went wrong, if anything did and nobody saw it; the window outlives this process. */
  public void tell(int status) {
    complaint(status).ifPresent(DesktopStart::show);
  }

  /** In a process of its own: in this one Java may have settled that there are no windows. */
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
      // It went to standard error too, and there is nobody else to tell.
    }
  }
}
