package org.selectiverenderer.study.threshold;

import java.util.List;

/**
 * A trial of a threshold pilot.
 *
 * @param number from 1
 * @param object DEF of the object
 * @param rung rung of the version shown
 * @param view index of the view of all its pictures, from 0
 * @param catching in a catch trial the object whose original is shown instead of the version; else
 *     empty
 * @param choices possible answers: {@link #LEFT} and {@link #RIGHT}, or objects
 * @param right the right answer
 */
public record ThresholdTrial(
    int number,
    String object,
    int rung,
    int view,
    String catching,
    List<String> choices,
    String right) {
  /** Answer that the left picture differs. */
  public static final String LEFT = "left";

  /** Answer that the right picture differs. */
  public static final String RIGHT = "right";

  /** Answer that the object is not recognised. */
  public static final String NONE = "none";

  public ThresholdTrial {
    choices = List.copyOf(choices);
  }

  /** Returns whether this is a catch trial. */
  public boolean catches() {
    return !catching.isEmpty();
  }
}
