package org.selectiverenderer.app.headset;

/** A command that the user of a headset gives with the controllers; one event for each press. */
public enum ControllerCommand {
  /** The "yes" button went down. */
  YES,
  /** The "no" button went down. */
  NO,
  /** The stick was pushed away from the user: more, or the item above. */
  MORE,
  /** The stick was pulled towards the user: less, or the item below. */
  LESS,
  /**
   * The button of the pointing hand went down. This event comes before any other event of the same
   * button; where the hand pointed at something, the other event is ignored.
   */
  CHOOSE
}
