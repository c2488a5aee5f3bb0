package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A term of the linear model: the factors, or the covariate, that an effect is about.
 *
 * @param within the within factors of the term, in the design's order
 * @param between the between factors of the term
 * @param covariate a covariate, which is in no term with between factors, because slopes are
 *     assumed equal in all groups
 */
public record Term(List<Factor> within, List<Factor> between, Optional<String> covariate) {
  /** The intercept: the grand mean. */
  static final Term INTERCEPT = new Term(List.of(), List.of(), Optional.empty());

  /** Makes defensive copies, so that the record is immutable. */
  public Term {
    within = List.copyOf(within);
    between = List.copyOf(between);
  }

  /**
   * Returns all terms of a design except the intercept: for each set of within factors, smaller
   * sets first, the terms with between factors, then those with covariates.
   */
  static List<Term> of(FactorialDesign design) {
    List<Term> terms = new ArrayList<>();
    for (List<Factor> within : subsets(design.withinFactors())) {
      for (List<Factor> between : subsets(design.betweenFactors())) {
        if (!within.isEmpty() || !between.isEmpty()) {
          terms.add(new Term(within, between, Optional.empty()));
        }
      }
      for (String covariate : design.covariates()) {
        terms.add(new Term(within, List.of(), Optional.of(covariate)));
      }
    }
    return terms;
  }

  /**
   * Returns all sets of the factors that have two or more levels, by size, then in the order of the
   * factors.
   */
  private static List<List<Factor>> subsets(List<Factor> factors) {
    List<Factor> varying = factors.stream().filter(Factor::varies).toList();
    List<List<Factor>> subsets = new ArrayList<>();
    for (int size = 0; size <= varying.size(); size++) {
      // A larger number has a later factor's bit reversed, so that earlier factors come first.
      for (int bits = (1 << varying.size()) - 1; bits >= 0; bits--) {
        if (Integer.bitCount(bits) == size) {
          List<Factor> subset = new ArrayList<>();
          for (int i = 0; i < varying.size(); i++) {
            if ((bits >> (varying.size() - 1 - i) & 1) == 1) {
              subset.add(varying.get(i));
            }
          }
          subsets.add(subset);
        }
      }
    }
    return subsets;
  }

  /** Returns the names of the factors and of the covariate. */
  public List<String> names() {
    return Stream.of(
            within.stream().map(Factor::name),
            between.stream().map(Factor::name),
            covariate.stream())
        .flatMap(name -> name)
        .toList();
  }

  /** Returns the name {@code within x between x covariate}. */
  public String name() {
    return names().isEmpty() ? "intercept" : String.join(" x ", names());
  }

  /** Returns whether another term contains this one (all its factors and its covariate). */
  public boolean isIn(Term other) {
    return other.within.containsAll(within)
        && other.between.containsAll(between)
        && (covariate.isEmpty() || covariate.equals(other.covariate));
  }

  /** Returns the kind of effect. */
  public EffectKind kind() {
    if (covariate.isPresent()) {
      return EffectKind.COVARIATE;
    }
    if (within.isEmpty()) {
      return between.isEmpty() ? EffectKind.INTERCEPT : EffectKind.BETWEEN;
    }
    return between.isEmpty() ? EffectKind.WITHIN : EffectKind.INTERACTION;
  }
}
