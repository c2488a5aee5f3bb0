package org.selectiverenderer.runtime.script;

/**
 * Ends a call that does not end by itself. An error, since a script can catch exceptions but not
 * this.
 */
@SuppressWarnings("serial") // Never written to files.
final class Stopped extends Error {
  private final int line;

  /**
   * @param line of the script, from 1; 0 if unknown
   */
  Stopped(String reason, int line) {
    super(reason, null, false, false);
    this.line = line;
  }

  int line() {
    return line;
  }
}
