package org.selectiverenderer.cli.output;

/** Ends a command with one sentence for the user. */
public final class CommandFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final boolean wrongUsage;

  private CommandFailure(String message, boolean wrongUsage) {
    super(message);
    this.wrongUsage = wrongUsage;
  }

  /** Arguments that do not fit together; the user is pointed at {@code --help}. */
  public static CommandFailure usage(String sentence) {
    return new CommandFailure(sentence, true);
  }

  /** Something outside that the command needs and cannot use, such as a display. */
  public static CommandFailure environment(String sentence) {
    return new CommandFailure(sentence, false);
  }

  public boolean wrongUsage() {
    return wrongUsage;
  }
}
