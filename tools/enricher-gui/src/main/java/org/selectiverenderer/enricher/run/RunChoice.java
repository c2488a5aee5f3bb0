package org.selectiverenderer.enricher.run;

import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.control.Condition;

/**
 * How to run a scene.
 *
 * @param condition as {@code run --condition} names it
 * @param fromHere whether to begin where the preview is, not where the scene begins
 */
public record RunChoice(String condition, boolean fromHere) {
  /** As {@code run} names them. */
  static final List<String> CONDITIONS =
      Arrays.stream(Condition.values()).map(Condition::spelling).toList();

  /** As visitors see it. */
  public static final RunChoice USUAL = new RunChoice(Condition.SELECTIVE.spelling(), false);
}
