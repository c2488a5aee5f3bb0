package org.selectiverenderer.statistics.bayes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectPrior;
import org.selectiverenderer.statistics.anova.Term;

/** Bayes factors of the effects of an analysis. */
public final class BayesianAnova {
  private final Anova anova;
  private final List<Term> terms;

  private BayesianAnova(Anova anova) {
    this.anova = anova;
    terms = anova.effects().stream().map(Effect::term).toList();
  }

  /** Why a design has no Bayes factors of effects, empty when it has: without its full stop. */
  public static Optional<String> obstacle(Anova anova) {
    return anova.design().covariates().isEmpty()
        ? Optional.empty()
        : Optional.of("Bayes factors of effects are not computed in designs with covariates");
  }

  /**
   * Of each effect, in order, with the prior of the analysis's options.
   *
   * @return not numbers where {@link #obstacle} says why, and where there is no F
   */
  public static List<EffectEvidence> of(Anova anova) {
    return new BayesianAnova(anova).evidence(List.of());
  }

  /** The same, and with {@link EffectPrior#ROBUSTNESS other widths} of the prior. */
  public static List<EffectEvidence> withRobustness(Anova anova) {
    return new BayesianAnova(anova).evidence(EffectPrior.ROBUSTNESS);
  }

  private List<EffectEvidence> evidence(List<Double> scales) {
    boolean defined =
        obstacle(anova).isEmpty()
            && anova.effects().stream().allMatch(effect -> Double.isFinite(effect.f()));
    if (!defined) {
      return terms.stream()
          .map(term -> new EffectEvidence(term, Double.NaN, 0, List.of()))
          .toList();
    }
    ModelEvidence models =
        new ModelEvidence(anova.design(), terms, anova.options().prior());
    return terms.stream().map(term -> of(term, models, scales)).toList();
  }

  private EffectEvidence of(Term term, ModelEvidence models, List<Double> scales) {
    Set<Term> without = new HashSet<>();
    for (Term other : terms) {
      if (!term.isIn(other)) {
        without.add(other);
      }
    }
    Set<Term> with = new HashSet<>(without);
    with.add(term);
    double fixed = anova.options().prior().fixed();
    List<Double> batches = new ArrayList<>();
    for (int batch = 0; batch < models.batches(); batch++) {
      batches.add(
          Math.exp(models.log(without, fixed, batch) - models.log(with, fixed, batch)));
    }
    double mean = batches.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
    double squares =
        batches.stream().mapToDouble(batch -> (batch - mean) * (batch - mean)).sum();
    double error =
        batches.size() == 1
            ? 0
            : Math.sqrt(squares / (batches.size() - 1.0) / batches.size()) / mean;
    List<EffectEvidence.Point> points =
        scales.stream()
            .sorted(Comparator.naturalOrder())
            .map(scale -> new EffectEvidence.Point(scale, mean(models, without, with, scale)))
            .toList();
    return new EffectEvidence(term, mean, error, points);
  }

  private static double mean(
      ModelEvidence models, Set<Term> without, Set<Term> with, double scale) {
    double sum = 0;
    for (int batch = 0; batch < models.batches(); batch++) {
      sum += Math.exp(models.log(without, scale, batch) - models.log(with, scale, batch));
    }
    return sum / models.batches();
  }
}
