package org.selectiverenderer.app.headset;

/** What the user of a headset answers by his controllers; once for each press. */
public enum HeadsetAnswer {
  /** The button for yes went down. */
  YES,
  /** The button for no went down. */
  NO,
  /** The stick was pushed away: more, or the one above. */
  MORE,
  /** The stick was pulled: less, or the one below. */
  LESS,
  /**
   * The button of the hand that points went down. It comes before what else the same button
   * answers; where something was pointed at, that does not count.
   */
  CHOOSE
}
