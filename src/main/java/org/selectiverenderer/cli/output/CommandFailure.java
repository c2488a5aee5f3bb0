package org.selectiverenderer.cli.output;

/** Ends a command with a message of one sentence for the user. */
public final class CommandFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean wrongUsage;

  private CommandFailure(String message, boolean wrongUsage) {
    super(message);
    this.wrongUsage = wrongUsage;
  }

  /** Creates a failure because of wrong arguments; the user is referred to {@code --help}. */
  public static CommandFailure usage(String sentence) {
    return new CommandFailure(sentence, true);
  }

  /** Creates a failure because of something in the environment, such as a missing display. */
  public static CommandFailure environment(String sentence) {
    return new CommandFailure(sentence, false);
  }

  public boolean wrongUsage() {
    return wrongUsage;
  }
}
