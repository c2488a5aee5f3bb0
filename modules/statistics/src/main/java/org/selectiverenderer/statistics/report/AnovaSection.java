package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.assumption.AssumptionChecks;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;

/** Builds the tables of one analysis of variance: those of Figs 92 to 94 of the thesis and more. */
final class AnovaSection {
  private AnovaSection() {}

  static List<ReportBlock> of(Anova anova, List<EffectBayesFactors> evidence) {
    EffectTables effects = new EffectTables(anova, evidence);
    MeansTables means = new MeansTables(anova);
    List<ReportBlock> all = new ArrayList<>();
    all.add(means.descriptives());
    all.add(effects.effects());
    if (anova.effects().stream().anyMatch(effect -> !effect.multivariate().isEmpty())) {
      all.add(effects.multivariate());
    }
    if (anova.effects().stream().anyMatch(effect -> effect.sphericity().isPresent())) {
      all.add(effects.sphericity());
    }
    all.addAll(AssumptionSection.of(AssumptionChecks.of(anova)));
    all.add(effects.absence());
    effects.robustness().ifPresent(all::add);
    all.add(means.means());
    if (!anova.comparisons().isEmpty()) {
      all.add(means.comparisons());
    }
    return all;
  }
}
