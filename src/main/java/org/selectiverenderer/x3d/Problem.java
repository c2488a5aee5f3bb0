package org.selectiverenderer.x3d;

/**
 * Something about a scene that its author should know.
 *
 * @param message one sentence: what is wrong and what is done about it
 */
public record Problem(Severity severity, Location location, String message) {
  /** ERROR and WARNING make a command end with status 1; INFO does not. */
  public enum Severity {
    ERROR,
    WARNING,
    INFO
  }

  /** {@code file:line:column: message}, the form that editors and terminals link. */
  @Override
  public String toString() {
    return location + ": " + message;
  }
}
