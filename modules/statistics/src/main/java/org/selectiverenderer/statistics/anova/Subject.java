package org.selectiverenderer.statistics.anova;

import java.util.List;

/**
 * A participant's complete data.
 *
 * @param group index of the combination of the between factors' levels
 * @param values finite scores, one for each combination of the within factors' levels
 * @param covariates finite values, one for each covariate of the design
 */
public record Subject(String id, int group, List<Double> values, List<Double> covariates) {
  /** Makes defensive copies, so that the record is immutable. */
  public Subject {
    values = List.copyOf(values);
    covariates = List.copyOf(covariates);
  }

  /** Creates a subject of a design without covariates. */
  public Subject(String id, int group, List<Double> values) {
    this(id, group, values, List.of());
  }
}
