package org.selectiverenderer.enricher.run;

import java.util.Arrays;
import java.util.List;
import org.selectiverenderer.schema.Condition;

/**
 * The options of a run.
 *
 * @param condition value of {@code run --condition}
 * @param fromHere whether to begin at the preview's pose instead of the start viewpoint
 */
public record RunOptions(String condition, boolean fromHere) {
  /** All values of {@code run --condition}. */
  static final List<String> CONDITIONS =
      Arrays.stream(Condition.values()).map(Condition::spelling).toList();

  /** The default: as visitors see the scene. */
  public static final RunOptions USUAL = new RunOptions(Condition.SELECTIVE.spelling(), false);
}
