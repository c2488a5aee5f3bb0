package org.selectiverenderer.command.output;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.Problem;

/**
 * The output streams of a command. Data goes to {@code out}, which is buffered: a command that
 * streams lines to a waiting reader flushes after each. Messages and progress go to {@code err},
 * which is not buffered. Lines end with LF on every system, as in files.
 *
 * <p>All that the program prints comes through here, and names and texts of scenes are other
 * people's. So both streams write control characters as {@link ControlCharacterEscaper} does: no
 * scene and no name of a file commands the terminal. What is one line is printed by {@link #line},
 * {@link #message} or {@link #problem}, which keep it one.
 */
public final class Console {
  private final PrintStream plainOut;
  private final PrintStream plainErr;
  private final PrintStream out;
  private final PrintStream err;
  private final boolean colours;

  /**
   * @param out receives data only, as UTF-8; throws {@link StandardOutputException} once it cannot
   *     be written
   * @param err receives messages and progress
   * @param colours whether help and reports may be coloured: only on a terminal
   */
  public Console(PrintStream out, PrintStream err, boolean colours) {
    plainOut = out;
    plainErr = err;
    this.out = filtered(out);
    this.err = filtered(err);
    this.colours = colours;
  }

  private static PrintStream filtered(PrintStream stream) {
    return new PrintStream(new ControlCharacterFilter(stream), false, StandardCharsets.UTF_8);
  }

  /** Returns the stream for data; it makes control characters visible. */
  public PrintStream out() {
    return out;
  }

  /** Returns the stream for messages; it makes control characters visible. */
  public PrintStream err() {
    return err;
  }

  /** Returns whether help and reports may be coloured. */
  public boolean colours() {
    return colours;
  }

  /** Prints one line of data; line ends within it are made visible. */
  public void line(String line) {
    out.println(ControlCharacterEscaper.line(line));
  }

  /** Prints text with the program's own escape sequences, in which other text is escaped. */
  public void coloured(String text) {
    out.flush();
    plainOut.print(text);
  }

  /** Prints a problem as {@code file:line:column: message}. */
  public void problem(Problem problem) {
    message(problem.toString());
  }

  /** Prints a message; line ends within it are made visible. */
  public void message(String line) {
    err.println(ControlCharacterEscaper.line(line));
  }

  /** Returns whether a user can be asked: input and output are a terminal. */
  public boolean canAsk() {
    return terminal();
  }

  /** Returns whether this process's input and output are a terminal. */
  public static boolean terminal() {
    java.io.Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      // Since Java 22 there is a console without a terminal, too.
      return (boolean) java.io.Console.class.getMethod("isTerminal").invoke(console);
    } catch (ReflectiveOperationException e) {
      return true;
    }
  }

  /**
   * Asks the user a question, in one line.
   *
   * @return the answer; empty where input or output is no terminal, or it was closed
   */
  public Optional<String> ask(String question) {
    return canAsk()
        ? Optional.ofNullable(
            System.console().readLine("%s", ControlCharacterEscaper.line(question)))
        : Optional.empty();
  }

  /** Prints a message over the current line, and stays on it. */
  public void overwrite(String line) {
    plainErr.print("\r" + ControlCharacterEscaper.line(line));
    plainErr.flush();
  }
}
