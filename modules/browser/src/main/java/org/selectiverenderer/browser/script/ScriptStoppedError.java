package org.selectiverenderer.browser.script;

/**
 * Stops a script call that exceeds a limit. It is an Error, because a script can catch exceptions
 * but not errors.
 */
@SuppressWarnings("serial") // Never written to files.
final class ScriptStoppedError extends Error {
  private final int line;

  /**
   * @param line the line of the script, from 1; 0 if unknown
   */
  ScriptStoppedError(String reason, int line) {
    super(reason, null, false, false);
    this.line = line;
  }

  int line() {
    return line;
  }
}
