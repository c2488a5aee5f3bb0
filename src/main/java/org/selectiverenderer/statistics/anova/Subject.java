package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * A participant's complete data.
 *
 * @param group index of the combination of the between factors' levels
 * @param values finite, one for each combination of the within factors' levels
 * @param covariates finite, one for each of the design
 */
public record Subject(String id, int group, List<Double> values, List<Double> covariates) {
  /** Keeps copies, so that it stays as it is. */
  public Subject {
    values = List.copyOf(values);
    covariates = List.copyOf(covariates);
  }

  /** Of a design without covariates. */
  public Subject(String id, int group, List<Double> values) {
    this(id, group, values, List.of());
  }
}
