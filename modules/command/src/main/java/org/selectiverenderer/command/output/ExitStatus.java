package org.selectiverenderer.command.output;

import org.selectiverenderer.base.problem.ProblemCollector;

/** The exit statuses of a command. */
public enum ExitStatus {
  /** Done, nothing to say about the input. */
  DONE(0),
  /** Done as far as possible, but the input has findings, or missing or bad data. */
  PROBLEMS(1),
  /** Wrong usage, or a file, a port or a display that could not be used. */
  FAILURE(2);

  private final int code;

  ExitStatus(int code) {
    this.code = code;
  }

  /** Returns the exit code of the process. */
  public int code() {
    return code;
  }

  /** Returns the status of an exit code. */
  public static ExitStatus of(int code) {
    return values()[code];
  }

  /** Returns {@link #PROBLEMS} if any error or warning was found, else {@link #DONE}. */
  public static ExitStatus of(ProblemCollector problems) {
    return problems.any() ? PROBLEMS : DONE;
  }
}
