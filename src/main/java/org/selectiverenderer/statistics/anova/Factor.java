package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * An independent variable.
 *
 * @param name as its column or the study calls it
 * @param levels in the order of reports; one level means that the design lacks the factor
 */
public record Factor(String name, List<String> levels) {
  /** Keeps copies, so that it stays as it is. */
  public Factor {
    levels = List.copyOf(levels);
  }

  /** Whether there is anything to compare. */
  public boolean varies() {
    return levels.size() > 1;
  }

  /**
   * One factor whose levels are the combinations of those of several, {@code a, b}, the last
   * factor's changing fastest.
   *
   * @param factors one or more; one alone is itself
   */
  public static Factor crossed(List<Factor> factors) {
    if (factors.size() == 1) {
      return factors.get(0);
    }
    List<String> levels = List.of("");
    for (Factor factor : factors) {
      List<String> longer = new ArrayList<>();
      for (String before : levels) {
        for (String level : factor.levels()) {
          longer.add(before.isEmpty() ? level : before + ", " + level);
        }
      }
      levels = longer;
    }
    return new Factor(
        factors.stream().map(Factor::name).collect(Collectors.joining(" x ")), levels);
  }
}
