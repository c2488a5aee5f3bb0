package org.selectiverenderer.command.output;

import java.io.PrintStream;
import org.selectiverenderer.base.problem.Problem;

/**
 * The output streams of a command. Data goes to {@code out}, which is buffered: a command that
 * streams lines to a waiting reader flushes after each. Messages and progress go to {@code err},
 * which is not buffered.
 *
 * @param out receives data only, as UTF-8; throws {@link StandardOutputException} once it cannot be
 *     written
 * @param err receives messages and progress
 * @param colours whether help may be coloured: only on a terminal
 */
public record Console(PrintStream out, PrintStream err, boolean colours) {
  /** Prints a problem as {@code file:line:column: message}. */
  public void problem(Problem problem) {
    err.println(problem);
  }

  /** Prints a message. */
  public void message(String line) {
    err.println(line);
  }
}
