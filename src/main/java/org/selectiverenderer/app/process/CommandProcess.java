package org.selectiverenderer.app.process;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.selectiverenderer.base.platform.ChildProcessCommand;

/**
 * A command of the program in a process of its own. It outlives this process: a session goes on
 * when the window that has started it is closed.
 */
public final class CommandProcess {
  /** The main class, by name, as the commands depend on the window and not the other way round. */
  private static final String MAIN = "org.selectiverenderer.cli.Main";

  /** The system property in which the launcher names the picture that it shows at once. */
  private static final String SPLASH = "selective-renderer.splash";

  /** The system property of the launcher's flags for light commands, with commas. */
  private static final String LIGHT = "selective-renderer.run-flags";

  /** Longest line that is handed on, in characters. */
  private static final int MOST = 2_000;

  private final Process process;

  private CommandProcess(Process process) {
    this.process = process;
  }

  /**
   * Starts a command.
   *
   * @param lines receives each line of its output, on a thread {@code command-output}
   * @param ended receives its exit status when it has ended, on that thread
   * @throws IOException if it cannot be started
   */
  public static CommandProcess start(
      ProgramCommand command, Consumer<String> lines, IntConsumer ended) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(ChildProcessCommand.of(MAIN, flags(command), command.words()))
            .redirectErrorStream(true);
    Process process = builder.start();
    process.getOutputStream().close(); // Nobody types; a question is answered by no answer.
    Thread hearing = new Thread(() -> hear(process, lines, ended), "command-output");
    hearing.setDaemon(true);
    hearing.start();
    return new CommandProcess(process);
  }

  /**
   * Returns the flags that the launcher would give to the command: a Swing window shows a picture
   * at once, and a command that loads and then does little gets code quickly.
   */
  private static List<String> flags(ProgramCommand command) {
    String splash = System.getProperty(SPLASH, "");
    if (command.opensSwingWindow()) {
      return splash.isEmpty() ? List.of() : List.of("-splash:" + splash);
    }
    String light = System.getProperty(LIGHT, "");
    return command.light() && !light.isEmpty() ? List.of(light.split(",")) : List.of();
  }

  private static void hear(Process process, Consumer<String> lines, IntConsumer ended) {
    try (BufferedReader output =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = output.readLine(); line != null; line = output.readLine()) {
        lines.accept(line.length() <= MOST ? line : line.substring(0, MOST) + " \u2026");
      }
    } catch (IOException e) {
      lines.accept(String.valueOf(e.getMessage())); // The exit status still tells how it ended.
    }
    try {
      ended.accept(process.waitFor());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Ends the command as Ctrl-C in a terminal does. A session then writes that it was aborted, and
   * can be resumed; Windows ends it at once, which its journal survives.
   */
  public void end() {
    process.destroy();
  }
}
