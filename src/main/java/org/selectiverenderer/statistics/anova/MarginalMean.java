package org.selectiverenderer.statistics.anova;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * An estimated marginal mean: of a combination of levels of some factors with equal weight for each
 * combination of the others (Searle, Speed and Milliken 1980, The American Statistician 34), at the
 * means of the covariates. Its error is the pooled one, as in SPSS.
 *
 * @param term whose combinations of levels it is one of; the intercept's is the mean of all
 * @param levels for each of the term's factors, by its name
 * @param df of the error
 */
public record MarginalMean(
    Term term,
    Map<String, String> levels,
    double mean,
    double standardError,
    double df,
    double low,
    double high) {
  /** Keeps the order of the levels. */
  public MarginalMean {
    levels = new LinkedHashMap<>(levels); // Map.copyOf forgets their order
  }

  /** The level of each factor, in the order of the factors. */
  @Override
  public Map<String, String> levels() {
    return new LinkedHashMap<>(levels);
  }

  /** The levels of within factors; empty: over all. */
  public Optional<String> within() {
    return joined(term.within());
  }

  /** The levels of between factors; empty: over all. */
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
