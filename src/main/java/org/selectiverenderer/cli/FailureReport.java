package org.selectiverenderer.cli;

import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.FailureSentence;
import org.selectiverenderer.cli.output.OutputFailure;

/** Reports the failure of a command in one line and returns the exit status. */
final class FailureReport {
  private final Console console;
  private final boolean stackTraces;

  /**
   * @param stackTraces whether the stack trace follows the line
   */
  FailureReport(Console console, boolean stackTraces) {
    this.console = console;
    this.stackTraces = stackTraces;
  }

  /**
   * Reports a failure.
   *
   * @param command the command as typed, such as {@code selective-renderer run}
   */
  ExitStatus report(String command, Throwable failure) {
    if (failure instanceof OutputFailure output && output.readerHasGone()) {
      return ExitStatus.DONE;
    }
    console.message(command + ": " + FailureSentence.of(failure));
    if (failure instanceof CommandFailure cause && cause.wrongUsage()) {
      console.message("Try '" + command + " --help'.");
    }
    if (stackTraces) {
      failure.printStackTrace(console.err());
    }
    return ExitStatus.FAILURE;
  }
}
