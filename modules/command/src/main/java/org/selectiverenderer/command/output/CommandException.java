package org.selectiverenderer.command.output;

/** Ends a command with a message of one sentence for the user. */
public final class CommandException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean wrongUsage;

  private CommandException(String message, boolean wrongUsage) {
    super(message);
    this.wrongUsage = wrongUsage;
  }

  /** Creates a failure because of wrong arguments; the user is referred to {@code --help}. */
  public static CommandException usage(String sentence) {
    return new CommandException(sentence, true);
  }

  /** Creates a failure because of something in the environment, such as a missing display. */
  public static CommandException environment(String sentence) {
    return new CommandException(sentence, false);
  }

  public boolean wrongUsage() {
    return wrongUsage;
  }
}
