package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.CorrectedDegreesOfFreedom;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectSize;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.MarginalMean;
import org.selectiverenderer.statistics.anova.MultivariateTest;
import org.selectiverenderer.statistics.anova.PairwiseComparison;
import org.selectiverenderer.statistics.anova.Sphericity;
import org.selectiverenderer.statistics.assumption.AssumptionChecks;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.data.Exclusion;

/** Writes an analysis of variance as JSON; docs/statistics.md lists the keys. */
final class AnovaJsonWriter {
  private AnovaJsonWriter() {}

  static void write(Anova anova, BayesianAnova bayes, ObjectNode json) {
    json.put("measure", anova.design().measure());
    factor(json, "within", anova.design().within());
    factor(json, "between", anova.design().between());
    ArrayNode factors = json.putArray("factors");
    for (Factor factor : anova.design().factors()) {
      ObjectNode node = factors.addObject().put("name", factor.name());
      node.put("kind", anova.design().withinFactors().contains(factor) ? "within" : "between");
      factor.levels().forEach(node.putArray("levels")::add);
    }
    anova.design().covariates().forEach(json.putArray("covariates")::add);
    json.put("participants", anova.design().subjects().size());
    effect(anova.intercept(), json.putObject("intercept"));
    ArrayNode effects = json.putArray("effects");
    List<EffectBayesFactors> evidence = bayes.withRobustness();
    for (int i = 0; i < anova.effects().size(); i++) {
      ObjectNode node = effects.addObject();
      effect(anova.effects().get(i), node);
      evidence(evidence.get(i), node);
      BayesianAnova.obstacle(anova).ifPresent(reason -> node.put("bf01_undefined", reason));
    }
    descriptives(anova.design(), json);
    ArrayNode means = json.putArray("marginal_means");
    anova.means().forEach(mean -> mean(mean, means.addObject()));
    JsonNumbers.put(json, "equivalence_bound", anova.bound());
    ArrayNode comparisons = json.putArray("comparisons");
    anova.comparisons().forEach(pair -> comparison(pair, comparisons.addObject()));
    AssumptionsJsonWriter.write(AssumptionChecks.of(anova), json.putObject("assumptions"));
  }

  static void options(AnovaOptions options, ObjectNode json) {
    JsonNumbers.put(json, "alpha", options.alpha());
    JsonNumbers.put(json, "confidence", options.confidence());
    JsonNumbers.put(json, "eta_confidence", options.etaConfidence());
    JsonNumbers.put(json, "equivalence_bound", options.differenceBound());
    json.put("equivalence_bound_unit", options.rawBound() ? "measure" : "sd");
    JsonNumbers.put(json, "equivalence_eta2", options.etaBound());
    JsonNumbers.put(json, "jzs_scale", options.priorScale());
    JsonNumbers.put(json, "prior_fixed", options.prior().fixed());
    JsonNumbers.put(json, "prior_random", options.prior().random());
    json.put("seed", options.prior().seed());
    json.put("sums_of_squares", "type III");
    json.put("sphericity_correction", options.sphericity().word());
    json.put("bayes_factor_effects", "JZS (Rouder et al. 2012), BF01");
    json.put("bayes_factor_comparisons", "JZS (Rouder et al. 2009), BF01");
    json.put("post_hoc", "Holm, Bonferroni, Tukey");
  }

  static void exclusions(List<Exclusion> exclusions, ObjectNode json) {
    ArrayNode array = json.putArray("exclusions");
    for (Exclusion exclusion : exclusions) {
      array
          .addObject()
          .put("file", exclusion.location().file())
          .put("line", exclusion.location().line())
          .put("column", exclusion.location().column())
          .put("participant", exclusion.participant())
          .put("reason", exclusion.reason());
    }
  }

  /** Writes the descriptive statistics of the cells, and those over all groups. */
  static void descriptives(FactorialDesign design, ObjectNode json) {
    ArrayNode cells = json.putArray("descriptives");
    ArrayNode totals = json.putArray("totals");
    for (CellDescriptives found : CellDescriptives.of(design)) {
      ObjectNode node = (found.between().isPresent() ? cells : totals).addObject();
      node.put("within", found.within().orElse(null));
      if (found.between().isPresent()) {
        node.put("between", design.between().varies() ? found.between().get() : null);
      }
      JsonNumbers.put(node, "mean", found.mean());
      JsonNumbers.put(node, "sd", found.sd());
      node.put("n", found.n());
    }
  }

  private static void factor(ObjectNode json, String key, Factor factor) {
    if (factor.varies()) {
      ObjectNode node = json.putObject(key).put("name", factor.name());
      factor.levels().forEach(node.putArray("levels")::add);
    } else {
      json.putNull(key);
    }
  }

  private static void effect(Effect effect, ObjectNode json) {
    json.put("effect", effect.name());
    JsonNumbers.put(json, "ss", effect.ss());
    JsonNumbers.put(json, "df1", effect.df1());
    JsonNumbers.put(json, "df2", effect.df2());
    JsonNumbers.put(json, "ms", effect.ms());
    JsonNumbers.put(json, "error_ss", effect.errorSs());
    JsonNumbers.put(json, "error_ms", effect.errorMs());
    JsonNumbers.put(json, "F", effect.f());
    JsonNumbers.put(json, "p", effect.p());
    effect.correction().ifPresent(correction -> correction(effect, correction, json));
    size(json, "partial_eta2", effect.partialEta());
    size(json, "generalized_eta2", effect.generalisedEta());
    size(json, "partial_omega2", effect.omega());
    if (effect.sphericity().isPresent()) {
      Sphericity found = effect.sphericity().get();
      ObjectNode node = json.putObject("sphericity");
      JsonNumbers.put(node, "mauchly_w", found.mauchlyW());
      JsonNumbers.put(node, "mauchly_p", found.mauchlyP());
      JsonNumbers.put(node, "greenhouse_geisser", found.greenhouseGeisser());
      JsonNumbers.put(node, "p_greenhouse_geisser", effect.correctedP(found.greenhouseGeisser()));
      JsonNumbers.put(node, "huynh_feldt", found.huynhFeldt());
      JsonNumbers.put(node, "p_huynh_feldt", effect.correctedP(found.huynhFeldt()));
    }
    if (!effect.multivariate().isEmpty()) {
      ArrayNode tests = json.putArray("multivariate");
      effect.multivariate().forEach(test -> multivariate(test, tests.addObject()));
    }
    ObjectNode equivalence = json.putObject("equivalence");
    JsonNumbers.put(equivalence, "partial_eta2_bound", effect.equivalence().bound());
    JsonNumbers.put(equivalence, "p", effect.equivalence().p());
    effect.flaw().ifPresent(flaw -> json.put("undefined", flaw));
  }

  private static void correction(
      Effect effect, CorrectedDegreesOfFreedom correction, ObjectNode json) {
    JsonNumbers.put(json, "p_uncorrected", effect.uncorrectedP());
    ObjectNode node = json.putObject("sphericity_correction").put("by", correction.by().word());
    JsonNumbers.put(node, "epsilon", correction.epsilon());
    JsonNumbers.put(node, "df1", correction.df1());
    JsonNumbers.put(node, "df2", correction.df2());
  }

  private static void evidence(EffectBayesFactors evidence, ObjectNode json) {
    JsonNumbers.put(json, "bf01", evidence.bf01());
    JsonNumbers.put(json, "bf01_error", evidence.error());
    JsonNumbers.put(json, "bf01_alone", evidence.alone().bf01());
    JsonNumbers.put(json, "bf01_alone_error", evidence.alone().error());
    ArrayNode points = json.putArray("bf01_robustness");
    for (EffectBayesFactors.Point point : evidence.robustness()) {
      ObjectNode node = points.addObject();
      JsonNumbers.put(node, "prior_fixed", point.scale());
      JsonNumbers.put(node, "bf01", point.bf01());
    }
  }

  private static void size(ObjectNode json, String key, EffectSize size) {
    JsonNumbers.put(json, key, size.value());
    if (Double.isFinite(size.low())) {
      ArrayNode interval = json.putArray(key + "_ci");
      ObjectNode bounds = json.objectNode();
      JsonNumbers.put(bounds, "low", size.low());
      JsonNumbers.put(bounds, "high", size.high());
      interval.add(bounds.get("low")).add(bounds.get("high"));
    } else {
      json.putNull(key + "_ci");
    }
  }

  private static void multivariate(MultivariateTest test, ObjectNode json) {
    json.put("statistic", test.statistic().name().toLowerCase(Locale.ROOT));
    JsonNumbers.put(json, "value", test.value());
    JsonNumbers.put(json, "F", test.f());
    JsonNumbers.put(json, "df1", test.df1());
    JsonNumbers.put(json, "df2", test.df2());
    JsonNumbers.put(json, "p", test.p());
    json.put("exact", test.exact());
  }

  private static void mean(MarginalMean mean, ObjectNode json) {
    json.put("within", mean.within().orElse(null)).put("between", mean.between().orElse(null));
    ObjectNode levels = json.putObject("levels");
    mean.levels().forEach(levels::put);
    JsonNumbers.put(json, "mean", mean.mean());
    JsonNumbers.put(json, "se", mean.standardError());
    JsonNumbers.put(json, "df", mean.df());
    JsonNumbers.put(json, "low", mean.low());
    JsonNumbers.put(json, "high", mean.high());
  }

  private static void comparison(PairwiseComparison pair, ObjectNode json) {
    json.put("factor", pair.factor()).put("at", pair.at().orElse(null));
    json.put("first", pair.first()).put("second", pair.second());
    JsonNumbers.put(json, "difference", pair.difference());
    JsonNumbers.put(json, "se", pair.standardError());
    JsonNumbers.put(json, "low", pair.low());
    JsonNumbers.put(json, "high", pair.high());
    JsonNumbers.put(json, "t", pair.t());
    JsonNumbers.put(json, "df", pair.df());
    JsonNumbers.put(json, "p", pair.p());
    JsonNumbers.put(json, "p_holm", pair.holm());
    JsonNumbers.put(json, "p_bonferroni", pair.bonferroni());
    JsonNumbers.put(json, "p_tukey", pair.tukey().orElse(Double.NaN));
    size(json, "d", pair.d());
    JsonNumbers.put(json, "tost_lower_t", pair.tost().lowerT());
    JsonNumbers.put(json, "tost_upper_t", pair.tost().upperT());
    JsonNumbers.put(json, "tost_p", pair.tost().p());
    JsonNumbers.put(json, "bf01_jzs", pair.bayesFactor());
    if (!Double.isFinite(pair.t())) {
      json.put("undefined", "the scores compared do not vary, so there is no t");
    }
  }
}
