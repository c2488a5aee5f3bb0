package org.selectiverenderer.cli.output;

import java.io.PrintStream;
import org.selectiverenderer.base.problem.Problem;

/**
 * Where a command writes. Data goes to {@code out}, which is buffered: a command that streams lines
 * to a waiting reader flushes after each. Messages and progress go to {@code err}, which is not.
 *
 * @param out takes data only, as UTF-8; throws {@link OutputFailure} once nobody can take it
 * @param err takes messages and progress
 * @param colours whether help may be coloured: only on a terminal
 */
public record Console(PrintStream out, PrintStream err, boolean colours) {
  /** Says what is wrong with a scene, as {@code file:line:column: message}. */
  public void problem(Problem problem) {
    err.println(problem);
  }

  /** Says what the program is doing or did. */
  public void message(String line) {
    err.println(line);
  }
}
