package org.selectiverenderer.openxr;

/** What the buttons of controllers mean. */
public enum HeadsetButton {
  /** Walks forward while it is held. */
  FORWARD("Walk forward"),
  /** Walks backward while it is held. */
  BACKWARD("Walk backward"),
  /** To the middle of the room that the head looks at. */
  TELEPORT("To the middle of the room looked at"),
  /** Where the head looks is straight ahead. */
  RECENTRE("Straight ahead is where I look"),
  /** Answers yes. */
  YES("Yes"),
  /** Answers no. */
  NO("No"),
  /** Chooses what the left hand points at. */
  CHOOSE_LEFT("Choose, left hand"),
  /** Chooses what the right hand points at. */
  CHOOSE_RIGHT("Choose, right hand");

  private final String shown;

  HeadsetButton(String shown) {
    this.shown = shown;
  }

  /** What the runtime shows to users who assign buttons. */
  String shown() {
    return shown;
  }
}
