package org.selectiverenderer.cli;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;

/**
 * A command: options as picocli fields, {@link #run} as the call into the package that does the
 * work. {@code --help}, {@code --version} and {@code --debug} come from {@link RootCommand}; an
 * example for the help is given as {@code @Command(footer = "...")}, under the heading that all
 * commands share.
 */
abstract class CliCommand implements Callable<Integer> {
  private final Console console;

  CliCommand(Console console) {
    this.console = console;
  }

  /** Where data and messages go. */
  final Console console() {
    return console;
  }

  /** Commands that this one groups; none as a rule. */
  List<CliCommand> subcommands() {
    return List.of();
  }

  /**
   * Does the command's work.
   *
   * @throws CommandFailure if it cannot be done, with the sentence for the user
   * @throws IOException reported as one line, with status {@link ExitStatus#FAILURE}
   */
  abstract ExitStatus run() throws IOException;

  @Override
  public final Integer call() throws IOException {
    return run().code();
  }
}
