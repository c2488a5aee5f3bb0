package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.CorrectedDegreesOfFreedom;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectKind;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.MultivariateTest;
import org.selectiverenderer.statistics.anova.Sphericity;
import org.selectiverenderer.statistics.anova.SphericityCorrection;
import org.selectiverenderer.statistics.bayes.BayesianAnova;
import org.selectiverenderer.statistics.bayes.EffectBayesFactors;
import org.selectiverenderer.statistics.report.ReportBlock.Table;

/**
 * Builds the tables of effects: F tests, multivariate tests, sphericity, equivalence and Bayes
 * factors.
 */
final class EffectTables {
  /**
   * Relative errors of Bayes factors below this are not shown, since they would be printed as 0.0
   * %.
   */
  private static final double SHOWN = 5e-4;

  private final Anova anova;
  private final List<EffectBayesFactors> evidence;

  EffectTables(Anova anova, List<EffectBayesFactors> evidence) {
    this.anova = anova;
    this.evidence = evidence;
  }

  Table effects() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    List<Effect> all = new ArrayList<>(List.of(anova.intercept()));
    all.addAll(anova.effects());
    Map<List<Factor>, List<Effect>> strata = new LinkedHashMap<>();
    for (Effect effect : all) {
      strata.computeIfAbsent(effect.term().within(), within -> new ArrayList<>()).add(effect);
    }
    strata.forEach(
        (within, own) -> {
          own.forEach(effect -> rows.add(effect(effect, figures)));
          rows.add(error(within, own.get(own.size() - 1), strata.size(), figures));
        });
    List<String> notes = new ArrayList<>(figures.notes());
    for (Effect effect : anova.effects()) {
      effect.correction().ifPresent(correction -> notes.add(corrected(effect, figures)));
    }
    return new Table(
        "Tests of effects (type III sums of squares)",
        List.of("effect", "SS", "df", "MS", "F", "p", "ηp² [90 % CI]", "ηG² [90 % CI]", "ωp²"),
        rows,
        notes);
  }

  private static List<String> error(
      List<Factor> within, Effect last, int strata, TableNumberFormat figures) {
    String name =
        within.isEmpty()
            ? "between"
            : strata == 2
                ? "within"
                : within.stream().map(Factor::name).collect(Collectors.joining(" x "));
    return List.of(
        "error (" + name + ")",
        figures.number(last.errorSs(), 3),
        figures.df(last.df2()),
        figures.number(last.errorMs(), 3),
        "",
        "",
        "",
        "",
        "");
  }

  private static List<String> effect(Effect effect, TableNumberFormat figures) {
    boolean bounds = effect.kind() != EffectKind.INTERCEPT;
    return List.of(
        effect.name(),
        figures.number(effect.ss(), 3),
        figures.df(effect.df1()),
        figures.number(effect.ms(), 3),
        figures.number(effect.f(), 3, effect.flaw()),
        figures.p(effect.p(), effect.flaw()) + (effect.correction().isPresent() ? " †" : ""),
        bounds
            ? figures.interval(effect.partialEta(), effect.flaw())
            : figures.number(effect.partialEta().value(), 3, effect.flaw()),
        bounds
            ? figures.interval(effect.generalisedEta(), effect.flaw())
            : figures.number(effect.generalisedEta().value(), 3, effect.flaw()),
        figures.number(effect.omega().value(), 3, effect.flaw()));
  }

  private static String corrected(Effect effect, TableNumberFormat figures) {
    CorrectedDegreesOfFreedom correction = effect.correction().orElseThrow();
    return "† %s: F(%s, %s) after %s (ε = %s); uncorrected, F(%s, %s) has p %s."
        .formatted(
            effect.name(),
            figures.number(correction.df1(), 2),
            figures.number(correction.df2(), 2),
            correction.by() == SphericityCorrection.GREENHOUSE_GEISSER
                ? "Greenhouse-Geisser"
                : "Huynh-Feldt",
            figures.number(correction.epsilon(), 3),
            figures.df(effect.df1()),
            figures.df(effect.df2()),
            figures.equalP(effect.uncorrectedP()));
  }

  Table multivariate() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    boolean bound = false;
    for (Effect effect : anova.effects()) {
      for (MultivariateTest test : effect.multivariate()) {
        Optional<String> few = Optional.of("too few participants for the approximation by F");
        bound |= !test.exact();
        rows.add(
            List.of(
                effect.name(),
                test.statistic().title(),
                figures.number(test.value(), 3),
                figures.number(test.f(), 3, few) + (test.exact() ? " *" : ""),
                figures.df(test.df1()),
                figures.df(test.df2()),
                figures.p(test.p(), few)));
      }
    }
    List<String> notes = new ArrayList<>(figures.notes());
    notes.add(
        "* exact statistic."
            + (bound ? " Others are approximations; Roy's F is an upper bound." : ""));
    return new Table(
        "Multivariate tests",
        List.of("effect", "statistic", "value", "F", "hypothesis df", "error df", "p"),
        rows,
        notes);
  }

  Table sphericity() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (Effect effect : anova.effects()) {
      if (effect.sphericity().isPresent()) {
        Sphericity found = effect.sphericity().get();
        rows.add(
            List.of(
                effect.name(),
                figures.p(effect.uncorrectedP(), effect.flaw()),
                figures.number(found.mauchlyW(), 3),
                figures.p(found.mauchlyP(), Optional.of("too few participants for Mauchly's test")),
                figures.number(found.greenhouseGeisser(), 3),
                figures.p(effect.correctedP(found.greenhouseGeisser()), effect.flaw()),
                figures.number(found.huynhFeldt(), 3),
                figures.p(effect.correctedP(found.huynhFeldt()), effect.flaw()),
                effect
                    .correction()
                    .map(used -> used.by().word().toUpperCase(Locale.ROOT))
                    .orElse("none")));
      }
    }
    return new Table(
        "Sphericity: p as designed, and with corrected degrees of freedom",
        List.of("effect", "p", "Mauchly's W", "p of W", "ε GG", "p GG", "ε HF", "p HF", "used"),
        rows,
        figures.notes());
  }

  Table absence() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    Optional<String> obstacle = BayesianAnova.obstacle(anova);
    boolean sampled = false;
    for (int i = 0; i < anova.effects().size(); i++) {
      Effect effect = anova.effects().get(i);
      EffectBayesFactors found = evidence.get(i);
      sampled |= found.error() > SHOWN || found.alone().error() > SHOWN;
      rows.add(
          List.of(
              effect.name(),
              figures.p(effect.p(), effect.flaw()),
              figures.p(effect.equivalence().p(), effect.flaw()),
              verdict(effect),
              bayes(found.beside(), figures, obstacle.or(effect::flaw)),
              bayes(found.alone(), figures, obstacle.or(effect::flaw))));
    }
    List<String> notes = new ArrayList<>(figures.notes());
    if (sampled) {
      notes.add(
          "±: standard error of the Monte Carlo integral (seed %d)."
              .formatted(anova.options().prior().seed()));
    }
    return new Table(
        "Absence of effects: equivalence (ηp² < %s) and Bayes factors"
            .formatted(figures.number(anova.options().etaBound(), 2)),
        List.of(
            "effect",
            "p of difference",
            "p of equivalence",
            "conclusion",
            "BF01 (JZS)",
            "BF01 alone"),
        rows,
        notes);
  }

  private static String bayes(
      EffectBayesFactors.Ratio found, TableNumberFormat figures, Optional<String> reason) {
    return figures.bayes(found.bf01(), reason)
        + (found.error() > SHOWN
            ? " ± %s %%".formatted(figures.number(100 * found.error(), 1))
            : "");
  }

  /**
   * Returns the table of Bayes factors for several scales of the prior; empty where there are no
   * Bayes factors.
   */
  Optional<Table> robustness() {
    if (evidence.stream().allMatch(found -> found.robustness().isEmpty())) {
      return Optional.empty();
    }
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    List<String> header = new ArrayList<>(List.of("effect"));
    evidence
        .get(0)
        .robustness()
        .forEach(point -> header.add("r = " + figures.number(point.scale(), 2)));
    for (EffectBayesFactors found : evidence) {
      List<String> row = new ArrayList<>(List.of(found.term().name()));
      found.robustness().forEach(point -> row.add(figures.bayes(point.bf01(), Optional.empty())));
      rows.add(row);
    }
    return Optional.of(
        new Table("BF01 with other widths r of the prior", header, rows, figures.notes()));
  }

  private String verdict(Effect effect) {
    return verdict(effect.p(), effect.equivalence().p(), anova.options().alpha());
  }

  /** Returns the conclusion from the tests of difference and of equivalence together. */
  static String verdict(double difference, double equivalence, double alpha) {
    boolean differs = difference < alpha;
    boolean equivalent = equivalence < alpha;
    return differs
        ? equivalent ? "differs, negligibly" : "differs"
        : equivalent ? "equivalent" : "undecided";
  }
}
