package org.selectiverenderer.app.session;

/** With what a participant answers the questions of a panel, which its last line explains. */
enum AnswerDevice {
  /** The keys of a keyboard. */
  KEYBOARD,

  /** The buttons and sticks of a headset's controllers. */
  BUTTONS,

  /** A ray from the hand, with the controller's trigger. */
  RAY
}
