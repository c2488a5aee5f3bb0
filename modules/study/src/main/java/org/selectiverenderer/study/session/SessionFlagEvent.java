package org.selectiverenderer.study.session;

import org.selectiverenderer.study.definition.SessionFlag;

/**
 * A quality flag raised in a session.
 *
 * @param step id of the step; empty if the flag concerns the whole session
 */
record SessionFlagEvent(SessionFlag flag, String step) {
  /** Describes the flag in a few words, for people. */
  String note() {
    return switch (flag) {
      case HEAD_LOG_INCOMPLETE -> "head log of " + step + " incomplete";
      default -> step.isEmpty() ? flag.meaning() : step + ": " + flag.meaning();
    };
  }
}
