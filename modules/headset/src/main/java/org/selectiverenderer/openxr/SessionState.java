package org.selectiverenderer.openxr;

/** The state of a session (XrSessionState, OpenXR 1.0, 9.3), in the order of OpenXR's numbers. */
enum SessionState {
  UNKNOWN,
  IDLE,
  READY,
  SYNCHRONIZED,
  VISIBLE,
  FOCUSED,
  STOPPING,
  LOSS_PENDING,
  EXITING;

  static SessionState of(int number) {
    return number >= 0 && number < values().length ? values()[number] : UNKNOWN;
  }
}
