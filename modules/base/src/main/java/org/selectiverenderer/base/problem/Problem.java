package org.selectiverenderer.base.problem;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;

/**
 * An error, warning or note about a user's file, with its location.
 *
 * @param message one sentence that says what is wrong and what the program does about it, on one
 *     line of limited length
 */
public record Problem(Severity severity, SourceLocation location, String message) {
  /** The severity; ERROR and WARNING make a command exit with status 1, INFO does not. */
  public enum Severity {
    /** The input is wrong, and the affected part is missing from the result. */
    ERROR,
    /** The input is probably not what its author meant. */
    WARNING,
    /** Information without a need to act. */
    INFO
  }

  private static final int MESSAGE_LENGTH = 500;

  /** Replaces control characters by question marks, and truncates a message that is too long. */
  public Problem {
    message = printable(message);
  }

  private static String printable(String message) {
    StringBuilder line = new StringBuilder(message.length());
    message
        .codePoints()
        .limit(MESSAGE_LENGTH)
        .map(c -> c == '\t' || ControlCharacterEscaper.isControl(c) ? '?' : c)
        .forEach(line::appendCodePoint);
    return message.length() > MESSAGE_LENGTH ? line + "..." : line.toString();
  }

  /**
   * Returns the problems of a file that another file names, of which the first error or warning
   * also tells where: the name of a file alone does not tell an author what refers to it.
   *
   * @param node the type of the node that names the file, such as {@code Inline}
   * @param location the location of that node
   */
  public static List<Problem> withReference(
      List<Problem> problems, String node, SourceLocation location) {
    List<Problem> told = new ArrayList<>(problems);
    for (int i = 0; i < told.size(); i++) {
      Problem first = told.get(i);
      if (first.severity != Severity.INFO) {
        String message =
            "%s (the %s at %s names this file)".formatted(first.message, node, location);
        told.set(i, new Problem(first.severity, first.location, message));
        break;
      }
    }
    return told;
  }

  /** Returns {@code file:line:column: message}, which editors and terminals turn into a link. */
  @Override
  public String toString() {
    return location + ": " + message;
  }
}
