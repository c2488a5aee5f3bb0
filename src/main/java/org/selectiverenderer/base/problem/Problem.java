package org.selectiverenderer.base.problem;

/**
 * Something about a scene that its author should know.
 *
 * @param message one sentence: what is wrong and what is done about it. Whatever names of the file
 *     it quotes, it is one line of a bearable length
 */
public record Problem(Severity severity, Location location, String message) {
  /** ERROR and WARNING make a command end with status 1; INFO does not. */
  public enum Severity {
    /** Something is wrong, and the result lacks it. */
    ERROR,
    /** Something is probably not as it is meant. */
    WARNING,
    /** Something worth knowing. */
    INFO
  }

  private static final int MESSAGE_LENGTH = 500;

  /**
   * Puts question marks in the place of control characters, and shortens a message that is too
   * long.
   */
  public Problem {
    message = printable(message);
  }

  private static String printable(String message) {
    StringBuilder line = new StringBuilder(message.length());
    message
        .codePoints()
        .limit(MESSAGE_LENGTH)
        .map(c -> Character.isISOControl(c) ? '?' : c)
        .forEach(line::appendCodePoint);
    return message.length() > MESSAGE_LENGTH ? line + "..." : line.toString();
  }

  /** {@code file:line:column: message}, the form that editors and terminals link. */
  @Override
  public String toString() {
    return location + ": " + message;
  }
}
