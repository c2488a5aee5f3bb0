package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * An independent variable.
 *
 * @param name the name of its column, or that in the study
 * @param levels names of the levels in the order of reports; one level means that the design lacks
 *     the factor
 */
public record Factor(String name, List<String> levels) {
  /** Makes defensive copies, so that the record is immutable. */
  public Factor {
    levels = List.copyOf(levels);
  }

  /** Returns whether the factor has two or more levels. */
  public boolean varies() {
    return levels.size() > 1;
  }

  /**
   * Returns one factor whose levels are the combinations of those of several, such as {@code a, b};
   * the last factor's level changes fastest.
   *
   * @param factors one or more; a single factor is returned as it is
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
