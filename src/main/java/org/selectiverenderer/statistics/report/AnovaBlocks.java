package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.assumption.Assumptions;
import org.selectiverenderer.statistics.bayes.EffectEvidence;

/** Builds the tables of one analysis of variance: those of Figs 92 to 94 of the thesis and more. */
final class AnovaBlocks {
  private AnovaBlocks() {}

  static List<Block> of(Anova anova, List<EffectEvidence> evidence) {
    EffectBlocks effects = new EffectBlocks(anova, evidence);
    MeansBlocks means = new MeansBlocks(anova);
    List<Block> all = new ArrayList<>();
    all.add(means.descriptives());
    all.add(effects.effects());
    if (anova.effects().stream().anyMatch(effect -> !effect.multivariate().isEmpty())) {
      all.add(effects.multivariate());
    }
    if (anova.effects().stream().anyMatch(effect -> effect.sphericity().isPresent())) {
      all.add(effects.sphericity());
    }
    all.addAll(AssumptionBlocks.of(Assumptions.of(anova)));
    all.add(effects.absence());
    effects.robustness().ifPresent(all::add);
    all.add(means.means());
    if (!anova.comparisons().isEmpty()) {
      all.add(means.comparisons());
    }
    return all;
  }
}
