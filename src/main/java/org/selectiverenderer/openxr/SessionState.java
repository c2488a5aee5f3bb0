package org.selectiverenderer.openxr;

/** What a runtime does with a session (OpenXR 1.0, 9.3); in the order of its numbers. */
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
