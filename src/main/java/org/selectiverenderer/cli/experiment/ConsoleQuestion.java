package org.selectiverenderer.cli.experiment;

import java.util.Optional;

/** Asks the user a question on the console. */
final class ConsoleQuestion {
  private ConsoleQuestion() {}

  /**
   * Asks a question.
   *
   * @return the answer; empty where input or output is no console, or it was closed
   */
  static Optional<String> ask(String question) {
    java.io.Console console = System.console();
    return console == null
        ? Optional.empty()
        : Optional.ofNullable(console.readLine("%s", question));
  }
}
