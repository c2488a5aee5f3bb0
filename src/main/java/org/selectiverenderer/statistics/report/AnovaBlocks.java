package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Comparison;
import org.selectiverenderer.statistics.anova.Descriptive;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectKind;
import org.selectiverenderer.statistics.anova.MarginalMean;
import org.selectiverenderer.statistics.anova.MultivariateTest;
import org.selectiverenderer.statistics.anova.Sphericity;
import org.selectiverenderer.statistics.report.Block.Table;

/** The tables of one analysis of variance, as in Figs 92 to 94 of the thesis and beyond. */
final class AnovaBlocks {
  private static final Optional<String> ONE =
      Optional.of("one participant has no standard deviation");
  private static final Optional<String> CONSTANT =
      Optional.of("the scores compared do not vary, so there is no t");

  private final Anova anova;

  private AnovaBlocks(Anova anova) {
    this.anova = anova;
  }

  static List<Block> of(Anova anova) {
    AnovaBlocks blocks = new AnovaBlocks(anova);
    List<Block> all = new ArrayList<>();
    all.add(blocks.descriptives());
    all.add(blocks.effects());
    if (anova.effects().stream().anyMatch(effect -> !effect.multivariate().isEmpty())) {
      all.add(blocks.multivariate());
    }
    if (anova.effects().stream().anyMatch(effect -> effect.sphericity().isPresent())) {
      all.add(blocks.sphericity());
    }
    all.add(blocks.absence());
    all.add(blocks.means());
    all.add(blocks.comparisons());
    return all;
  }

  private Table descriptives() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (Descriptive cell : anova.descriptives()) {
      rows.add(
          List.of(
              cell.within().orElse("all"),
              cell.between().orElse("total"),
              figures.number(cell.mean(), 4),
              figures.number(cell.sd(), 5, ONE),
              String.valueOf(cell.n())));
    }
    return new Table(
        "Descriptive statistics of " + anova.design().measure(),
        List.of(anova.design().within().name(), anova.design().between().name(), "mean", "SD", "n"),
        rows,
        figures.notes());
  }

  private Table effects() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    List<EffectKind> averages = List.of(EffectKind.INTERCEPT, EffectKind.BETWEEN);
    List<Effect> all = new ArrayList<>(List.of(anova.intercept()));
    all.addAll(anova.effects());
    for (boolean average : new boolean[] {true, false}) {
      List<Effect> own =
          all.stream().filter(effect -> averages.contains(effect.kind()) == average).toList();
      for (Effect effect : own) {
        rows.add(effect(effect, figures));
      }
      if (!own.isEmpty()) {
        Effect last = own.get(own.size() - 1);
        rows.add(
            List.of(
                average ? "error (between)" : "error (within)",
                figures.number(last.errorSs(), 3),
                figures.df(last.df2()),
                figures.number(last.errorMs(), 3),
                "",
                "",
                "",
                ""));
      }
    }
    return new Table(
        "Tests of effects (type III sums of squares)",
        List.of("effect", "SS", "df", "MS", "F", "p", "ηp² [90 % CI]", "ηG² [90 % CI]"),
        rows,
        figures.notes());
  }

  private static List<String> effect(Effect effect, TableFigures figures) {
    return List.of(
        effect.name(),
        figures.number(effect.ss(), 3),
        figures.df(effect.df1()),
        figures.number(effect.ms(), 3),
        figures.number(effect.f(), 3, effect.flaw()),
        figures.p(effect.p(), effect.flaw()),
        figures.interval(effect.partialEta(), effect.flaw()),
        figures.interval(effect.generalisedEta(), effect.flaw()));
  }

  private Table multivariate() {
    TableFigures figures = new TableFigures();
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

  private Table sphericity() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (Effect effect : anova.effects()) {
      if (effect.sphericity().isPresent()) {
        Sphericity found = effect.sphericity().get();
        rows.add(
            List.of(
                effect.name(),
                figures.number(found.mauchlyW(), 3),
                figures.p(found.mauchlyP(), Optional.of("too few participants for Mauchly's test")),
                figures.number(found.greenhouseGeisser(), 3),
                figures.p(effect.correctedP(found.greenhouseGeisser()), effect.flaw()),
                figures.number(found.huynhFeldt(), 3),
                figures.p(effect.correctedP(found.huynhFeldt()), effect.flaw())));
      }
    }
    return new Table(
        "Sphericity, and p with corrected degrees of freedom",
        List.of("effect", "Mauchly's W", "p of W", "ε GG", "p GG", "ε HF", "p HF"),
        rows,
        figures.notes());
  }

  private Table absence() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (Effect effect : anova.effects()) {
      rows.add(
          List.of(
              effect.name(),
              figures.p(effect.p(), effect.flaw()),
              figures.p(effect.equivalence().p(), effect.flaw()),
              verdict(effect),
              ""));
    }
    return new Table(
        "Absence of effects: equivalence (ηp² < %s) and Bayes factors"
            .formatted(figures.number(anova.options().etaBound(), 2)),
        List.of("effect", "p of difference", "p of equivalence", "conclusion", "BF01 (BIC)"),
        rows,
        figures.notes());
  }

  private String verdict(Effect effect) {
    return verdict(effect.p(), effect.equivalence().p(), anova.options().alpha());
  }

  /** What two tests together say. */
  static String verdict(double difference, double equivalence, double alpha) {
    boolean differs = difference < alpha;
    boolean equivalent = equivalence < alpha;
    return differs
        ? equivalent ? "differs, negligibly" : "differs"
        : equivalent ? "equivalent" : "undecided";
  }

  private Table means() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    for (MarginalMean mean : anova.means()) {
      rows.add(
          List.of(
              mean.within().orElse("all"),
              mean.between().orElse("all"),
              figures.number(mean.mean(), 3),
              figures.number(mean.standardError(), 3),
              "[" + figures.number(mean.low(), 3) + ", " + figures.number(mean.high(), 3) + "]"));
    }
    return new Table(
        "Estimated marginal means",
        List.of(
            anova.design().within().name(),
            anova.design().between().name(),
            "mean",
            "SE",
            "95 % CI"),
        rows,
        figures.notes());
  }

  private Table comparisons() {
    TableFigures figures = new TableFigures();
    List<List<String>> rows = new ArrayList<>();
    String family = "";
    for (Comparison pair : anova.comparisons()) {
      String heading =
          pair.factor()
              + pair.at()
                  .map(level -> " at " + level)
                  .orElse(
                      pair.factor().contains(" x ")
                          ? ", differences of differences"
                          : ", over all else");
      if (!heading.equals(family)) {
        family = heading;
        rows.add(List.of(heading));
      }
      rows.add(
          List.of(
              pair.first() + " − " + pair.second(),
              figures.interval(pair.difference(), pair.low(), pair.high(), 3, CONSTANT),
              figures.number(pair.t(), 2, CONSTANT),
              figures.df(pair.df()),
              figures.p(pair.p(), CONSTANT),
              figures.p(pair.holm(), CONSTANT),
              figures.number(pair.d().value(), 2, CONSTANT),
              figures.p(pair.tost().p(), CONSTANT),
              figures.bayes(pair.bayesFactor(), CONSTANT)));
    }
    return new Table(
        "Comparisons: differences, TOST with bounds ±%s, Bayes factors"
            .formatted(figures.number(anova.bound(), 3)),
        List.of(
            "difference", "[95 % CI]", "t", "df", "p", "p (Holm)", "d", "p (TOST)", "BF01 (JZS)"),
        rows,
        figures.notes());
  }
}
