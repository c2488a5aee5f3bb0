package org.selectiverenderer.statistics.bayes;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.apache.commons.math3.stat.StatUtils;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectPrior;
import org.selectiverenderer.statistics.anova.Term;

/**
 * The Bayes factors of the effects of an analysis. They are computed on first use and kept, since a
 * report shows them in several places.
 */
public final class BayesianAnova {
  private static final EffectBayesFactors.Ratio NONE = new EffectBayesFactors.Ratio(Double.NaN, 0);

  private final Anova anova;
  private final List<Term> terms;
  private @Nullable ModelEvidence models;
  private @Nullable List<EffectBayesFactors> effects;
  private @Nullable List<EffectBayesFactors> robust;

  /** Creates the Bayes factors of an analysis; none is computed yet. */
  public BayesianAnova(Anova anova) {
    this.anova = anova;
    terms = anova.effects().stream().map(Effect::term).toList();
  }

  /**
   * Returns why a design has no Bayes factors of effects, as a sentence without its full stop;
   * empty when it has.
   */
  public static Optional<String> obstacle(Anova anova) {
    return anova.design().covariates().isEmpty()
        ? Optional.empty()
        : Optional.of("Bayes factors of effects are not computed in designs with covariates");
  }

  /**
   * Returns the Bayes factors of each effect, in order, with the prior of the analysis's options.
   *
   * @return NaN where the design has an {@link #obstacle} or an effect has no F
   */
  public synchronized List<EffectBayesFactors> effects() {
    if (effects == null) {
      effects = evidence(List.of());
    }
    return effects;
  }

  /**
   * Returns the Bayes factors of each effect, also with {@link EffectPrior#ROBUSTNESS other scales}
   * of the prior.
   */
  public synchronized List<EffectBayesFactors> withRobustness() {
    if (robust == null) {
      robust = evidence(EffectPrior.ROBUSTNESS);
    }
    return robust;
  }

  private List<EffectBayesFactors> evidence(List<Double> scales) {
    boolean defined =
        obstacle(anova).isEmpty()
            && anova.effects().stream().allMatch(effect -> Double.isFinite(effect.f()));
    if (!defined) {
      return terms.stream()
          .map(term -> new EffectBayesFactors(term, NONE, NONE, List.of()))
          .toList();
    }
    if (models == null) {
      models = new ModelEvidence(anova.design(), terms, anova.options().prior());
    }
    ModelEvidence shared = models;
    return terms.stream().map(term -> of(term, shared, scales)).toList();
  }

  private EffectBayesFactors of(Term term, ModelEvidence models, List<Double> scales) {
    Set<Term> contained = new HashSet<>();
    Set<Term> others = new HashSet<>();
    for (Term other : terms) {
      if (!other.equals(term) && other.isIn(term)) {
        contained.add(other);
      }
      if (!term.isIn(other)) {
        others.add(other);
      }
    }
    double fixed = anova.options().prior().fixed();
    List<EffectBayesFactors.Point> points =
        scales.stream()
            .sorted(Comparator.naturalOrder())
            .map(
                scale ->
                    new EffectBayesFactors.Point(scale, factor(models, others, term, scale).bf01()))
            .toList();
    return new EffectBayesFactors(
        term, factor(models, others, term, fixed), factor(models, contained, term, fixed), points);
  }

  /** Returns the Bayes factor of a model against the same model with one more term. */
  private static EffectBayesFactors.Ratio factor(
      ModelEvidence models, Set<Term> without, Term term, double scale) {
    Set<Term> with = new HashSet<>(without);
    with.add(term);
    double[] batches = new double[models.batches()];
    for (int batch = 0; batch < batches.length; batch++) {
      batches[batch] = Math.exp(models.log(without, scale, batch) - models.log(with, scale, batch));
    }
    double mean = StatUtils.mean(batches);
    return new EffectBayesFactors.Ratio(
        mean,
        batches.length == 1 ? 0 : Math.sqrt(StatUtils.variance(batches) / batches.length) / mean);
  }
}
