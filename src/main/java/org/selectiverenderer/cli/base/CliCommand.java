package org.selectiverenderer.cli.base;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;

/**
 * A command: options as picocli fields, {@link #run} as the call into the package that does the
 * work. {@code --help}, {@code --version} and {@code --debug} come with the program; an example for
 * the help is given as {@code @Command(footer = "...")}, under the heading that all commands share.
 */
public abstract class CliCommand implements Callable<Integer> {
  private final Console console;

  protected CliCommand(Console console) {
    this.console = console;
  }

  /** Where data and messages go. */
  public final Console console() {
    return console;
  }

  /** Commands that this one groups; none as a rule. */
  public List<CliCommand> subcommands() {
    return List.of();
  }

  /**
   * Does the command's work.
   *
   * @throws CommandFailure if it cannot be done, with the sentence for the user
   * @throws IOException reported as one line, with status {@link ExitStatus#FAILURE}
   */
  public abstract ExitStatus run() throws IOException;

  @Override
  public final Integer call() throws IOException {
    return run().code();
  }
}
