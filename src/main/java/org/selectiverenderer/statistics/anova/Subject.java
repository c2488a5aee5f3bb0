package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * A participant's complete data.
 *
 * @param group index of the level of the between factor
 * @param values finite, one for each level of the within factor
 */
public record Subject(String id, int group, List<Double> values) {
  public Subject {
    values = List.copyOf(values);
  }
}
