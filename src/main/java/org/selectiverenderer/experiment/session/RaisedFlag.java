package org.selectiverenderer.experiment.session;

import org.selectiverenderer.experiment.study.SessionFlag;

/**
 * A flag of a session.
 *
 * @param step by its id; empty where it is of the session as a whole
 */
record RaisedFlag(SessionFlag flag, String step) {
  /** In a few words, for people. */
  String note() {
    return switch (flag) {
      case HEAD_LOG_INCOMPLETE -> "head log of " + step + " incomplete";
      default -> step.isEmpty() ? flag.meaning() : step + ": " + flag.meaning();
    };
  }
}
