package org.selectiverenderer.statistics.anova;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * An estimated marginal mean: the mean at a combination of levels of some factors, with equal
 * weights for all combinations of the other factors (Searle, Speed and Milliken 1980, The American
 * Statistician 34), at the means of the covariates. Its standard error uses the pooled error, as in
 * SPSS.
 *
 * @param term the term whose combination of levels this is; the mean of the intercept is the grand
 *     mean
 * @param levels the level of each of the term's factors, by the factor's name
 * @param df degrees of freedom of the error
 */
public record MarginalMean(
    Term term,
    Map<String, String> levels,
    double mean,
    double standardError,
    double df,
    double low,
    double high) {
  /** Makes a defensive copy that keeps the order of the levels. */
  public MarginalMean {
    levels = new LinkedHashMap<>(levels); // Map.copyOf forgets their order
  }

  /** Returns the level of each factor, in the order of the factors. */
  @Override
  public Map<String, String> levels() {
    return new LinkedHashMap<>(levels);
  }

  /** Returns the levels of the within factors; empty for a mean over all of them. */
  public Optional<String> within() {
    return joined(term.within());
  }

  /** Returns the levels of the between factors; empty for a mean over all of them. */
  public Optional<String> between() {
    return joined(term.between());
  }

  private Optional<String> joined(List<Factor> factors) {
    return factors.isEmpty()
        ? Optional.empty()
        : Optional.of(
            factors.stream()
                .map(factor -> Objects.requireNonNull(levels.get(factor.name())))
                .collect(Collectors.joining(", ")));
  }
}
