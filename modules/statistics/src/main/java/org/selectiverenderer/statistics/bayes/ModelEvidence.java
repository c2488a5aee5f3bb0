package org.selectiverenderer.statistics.bayes;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.statistics.anova.EffectPrior;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Term;

/**
 * Computes the evidence (marginal likelihood) of models of one design's data. Intermediate results
 * that models share are cached.
 */
final class ModelEvidence {
  private record NodeKey(Set<Term> terms, int batch) {}

  private record ModelKey(Set<Term> model, double scale, int batch) {}

  private final List<ErrorStratum> strata = new ArrayList<>();
  private final EffectPrior prior;
  private final int levels;
  private final VarianceEstimates scale;
  private final double dimensions;
  private final double averageDimensions;
  private final boolean sampled;
  private final Map<NonorthogonalTermBlock, Map<NodeKey, QuadratureGrid>> nodes =
      new IdentityHashMap<>();
  private final Map<ModelKey, Double> found = new HashMap<>();

  ModelEvidence(FactorialDesign design, List<Term> terms, EffectPrior prior) {
    this.prior = prior;
    levels = design.within().levels().size();
    List<List<Factor>> withins = new ArrayList<>(List.of(List.of()));
    terms.stream()
        .map(Term::within)
        .distinct()
        .filter(within -> !within.isEmpty())
        .forEach(withins::add);
    for (List<Factor> within : withins) {
      strata.add(
          ErrorStratum.of(
              design,
              within,
              terms.stream().filter(term -> term.within().equals(within)).toList()));
    }
    dimensions = strata.stream().mapToInt(ErrorStratum::dimensions).sum();
    averageDimensions = strata.get(0).dimensions();
    scale = scale();
    sampled =
        strata.stream()
            .flatMap(stratum -> stratum.components().stream())
            .anyMatch(component -> component.columns().size() > 2);
  }

  /**
   * Estimates the error variance from the residuals within participants if there are within
   * factors, else from those between participants.
   */
  private VarianceEstimates scale() {
    double rest = 0;
    double all = 0;
    double free = 0;
    for (ErrorStratum stratum : levels > 1 ? strata.subList(1, strata.size()) : strata) {
      rest += stratum.rest();
      all += stratum.sum();
      free += stratum.dimensions();
    }
    double variance = Math.max(rest, all * 1e-16) / free;
    double average = levels > 1 ? strata.get(0).sum() / averageDimensions / variance : 1;
    return new VarianceEstimates(variance, Math.max(1, average));
  }

  /**
   * Returns the number of batches that differ in {@link #log}; 1 if no Monte Carlo integration is
   * needed.
   */
  int batches() {
    return sampled ? ImportanceSampler.BATCHES : 1;
  }

  /**
   * Returns the logarithm of the evidence, up to a constant that all models of the design share.
   *
   * @param fixed prior scale r of the model's terms
   */
  double log(Set<Term> model, double fixed, int batch) {
    return found.computeIfAbsent(
        new ModelKey(model, fixed, batch), key -> integrated(model, fixed, batch));
  }

  private double integrated(Set<Term> model, double fixed, int batch) {
    List<List<QuadratureGrid>> tables = new ArrayList<>();
    for (ErrorStratum stratum : strata) {
      tables.add(
          stratum.components().stream()
              .map(component -> nodes(stratum, component, model, batch))
              .toList());
    }
    double[] start = {Math.log(scale.average() / levels)};
    return new LogIntegrator(
            logVariance -> {
              double variance = Math.exp(logVariance);
              double contrasts = -dimensions / 2 * logVariance;
              for (int i = 1; i < strata.size(); i++) {
                contrasts += log(strata.get(i), tables.get(i), fixed, variance, 1);
              }
              if (levels == 1) {
                return contrasts + log(strata.get(0), tables.get(0), fixed, variance, 1);
              }
              LogIntegrator inner =
                  new LogIntegrator(
                      logG -> averages(tables.get(0), fixed, variance, logG), start[0]);
              double value = inner.value();
              start[0] = inner.peak();
              return contrasts + value;
            },
            Math.log(scale.variance()))
        .value();
  }

  /**
   * Returns the log likelihood of the participants' averages times the prior of their g, at one g.
   */
  private double averages(List<QuadratureGrid> tables, double fixed, double variance, double logG) {
    double factor = 1 + levels * Math.exp(logG);
    return InverseGammaPrior.logDensity(logG, prior.random())
        - averageDimensions / 2 * Math.log(factor)
        + log(strata.get(0), tables, fixed, variance, factor);
  }

  private static double log(
      ErrorStratum stratum,
      List<QuadratureGrid> tables,
      double fixed,
      double variance,
      double factor) {
    double log = -stratum.rest() / (2 * variance * factor);
    for (QuadratureGrid table : tables) {
      log += table.log(variance, factor, fixed);
    }
    return log;
  }

  private QuadratureGrid nodes(
      ErrorStratum stratum, NonorthogonalTermBlock component, Set<Term> model, int batch) {
    List<TermDesignMatrix> terms =
        component.columns().stream().filter(column -> model.contains(column.term())).toList();
    Set<Term> own = Set.copyOf(terms.stream().map(TermDesignMatrix::term).toList());
    boolean drawn = terms.size() > 2;
    return nodes
        .computeIfAbsent(component, any -> new HashMap<>())
        .computeIfAbsent(
            new NodeKey(own, drawn ? batch : 0),
            key -> {
              if (terms.isEmpty()) {
                return QuadratureGrid.none(component);
              }
              VarianceEstimates here =
                  stratum.average() ? scale : new VarianceEstimates(scale.variance(), 1);
              double least = Math.min(prior.fixed(), EffectPrior.ROBUSTNESS.get(0));
              return drawn
                  ? new ImportanceSampler(component, terms, here, prior.fixed())
                      .nodes(prior.seed(), batch)
                  : QuadratureGrid.grid(component, terms, here, least);
            });
  }
}
