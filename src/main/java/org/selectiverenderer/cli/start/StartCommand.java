package org.selectiverenderer.cli.start;

import java.io.IOException;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import picocli.CommandLine.Command;

@Command(
    name = "start",
    description = {
      "Opens the start window: open a scene, look at the examples, begin the enricher or a study,"
          + " check this machine.",
      "The desktop's menu opens it too."
    },
    footer = "  ./selective-renderer start")
public final class StartCommand extends CliCommand {
  /** Opens the start window and waits until it is closed. */
  @FunctionalInterface
  public interface Window {
    /**
     * @throws IOException with one line if there is no display
     */
    ExitStatus open() throws IOException;
  }

  private final Window window;

  /**
   * @param window opens the start window
   */
  public StartCommand(Console console, Window window) {
    super(console);
    this.window = window;
  }

  @Override
  public ExitStatus run() throws IOException {
    return window.open();
  }
}
