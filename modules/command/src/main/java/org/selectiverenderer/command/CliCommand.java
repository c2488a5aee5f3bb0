package org.selectiverenderer.command;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;

/**
 * A command of the program: its options are picocli fields, and {@link #run} calls the package that
 * implements it. {@code --help}, {@code --version} and {@code --debug} come with the program; an
 * example for the help is given as {@code @Command(footer = "...")}, under the heading that all
 * commands share.
 */
public abstract class CliCommand implements Callable<Integer> {
  private final Console console;

  protected CliCommand(Console console) {
    this.console = console;
  }

  /** Returns the console for data and messages. */
  public final Console console() {
    return console;
  }

  /** Returns the subcommands; most commands have none. */
  public List<CliCommand> subcommands() {
    return List.of();
  }

  /**
   * Executes the command.
   *
   * @throws CommandException if the command fails, with the message for the user
   * @throws IOException reported as one line, with status {@link ExitStatus#FAILURE}
   */
  public abstract ExitStatus run() throws IOException;

  @Override
  public final Integer call() throws IOException {
    return run().code();
  }
}
