package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * An independent variable.
 *
 * @param name as its column or the study calls it
 * @param levels in the order of reports; one level means that the design lacks the factor
 */
public record Factor(String name, List<String> levels) {
  public Factor {
    levels = List.copyOf(levels);
  }

  /** Whether there is anything to compare. */
  public boolean varies() {
    return levels.size() > 1;
  }
}
