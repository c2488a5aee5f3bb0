package org.selectiverenderer.experiment.threshold;

import java.util.List;

/**
 * A trial.
 *
 * @param number from 1
 * @param object that it is about, by its DEF
 * @param rung of the version that it shows
 * @param view from which all its pictures are taken, from 0
 * @param catching the object whose original is shown in the version's place, as whoever attends
 *     must see; empty in most trials
 * @param choices what may be answered: {@link #LEFT} and {@link #RIGHT}, or objects
 * @param right the right one of them
 */
public record ThresholdTrial(
    int number,
    String object,
    int rung,
    int view,
    String catching,
    List<String> choices,
    String right) {
  /** The left picture differs. */
  public static final String LEFT = "left";

  /** The right picture differs. */
  public static final String RIGHT = "right";

  /** The object is not recognised. */
  public static final String NONE = "none";

  public ThresholdTrial {
    choices = List.copyOf(choices);
  }

  /** Whether it only shows that somebody attends. */
  public boolean catches() {
    return !catching.isEmpty();
  }
}
