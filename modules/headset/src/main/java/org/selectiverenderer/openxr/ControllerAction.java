package org.selectiverenderer.openxr;

/** The boolean actions of the program, which are bound to buttons of controllers. */
public enum ControllerAction {
  /** Walks forward while the button is held. */
  FORWARD("Walk forward"),
  /** Walks backward while the button is held. */
  BACKWARD("Walk backward"),
  /** Teleports to the middle of the room that the head looks at. */
  TELEPORT("To the middle of the room looked at"),
  /** Makes the heading of the head straight ahead. */
  RECENTRE("Straight ahead is where I look"),
  /** Answers yes. */
  YES("Yes"),
  /** Answers no. */
  NO("No"),
  /** Chooses the target of the left hand's ray. */
  CHOOSE_LEFT("Choose, left hand"),
  /** Chooses the target of the right hand's ray. */
  CHOOSE_RIGHT("Choose, right hand");

  private final String shown;

  ControllerAction(String shown) {
    this.shown = shown;
  }

  /** Returns the localized name, which the runtime shows to users who rebind actions. */
  String shown() {
    return shown;
  }
}
