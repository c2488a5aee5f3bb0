package org.selectiverenderer.statistics.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.CellDescriptives;
import org.selectiverenderer.statistics.anova.EffectSize;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.MarginalMean;
import org.selectiverenderer.statistics.anova.PairwiseComparison;
import org.selectiverenderer.statistics.report.ReportBlock.Table;

/** Builds the tables of descriptive statistics, estimated marginal means and comparisons. */
final class MeansTables {
  private static final Optional<String> ONE =
      Optional.of("one participant has no standard deviation");
  private static final Optional<String> CONSTANT =
      Optional.of("the scores compared do not vary, so there is no t");

  private final Anova anova;

  MeansTables(Anova anova) {
    this.anova = anova;
  }

  Table descriptives() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (CellDescriptives cell : anova.descriptives()) {
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

  Table means() {
    List<Factor> factors = anova.design().factors();
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    for (MarginalMean mean : anova.means()) {
      List<String> row = new ArrayList<>();
      factors.forEach(factor -> row.add(mean.levels().getOrDefault(factor.name(), "all")));
      row.add(figures.number(mean.mean(), 3));
      row.add(figures.number(mean.standardError(), 3));
      row.add("[" + figures.number(mean.low(), 3) + ", " + figures.number(mean.high(), 3) + "]");
      rows.add(row);
    }
    List<String> header = new ArrayList<>(factors.stream().map(Factor::name).toList());
    header.addAll(List.of("mean", "SE", "95 % CI"));
    List<String> notes = new ArrayList<>(figures.notes());
    if (!anova.design().covariates().isEmpty()) {
      notes.add(
          "At the means of the covariates: "
              + String.join(", ", anova.design().covariates())
              + ".");
    }
    return new Table("Estimated marginal means", header, rows, notes);
  }

  Table comparisons() {
    TableNumberFormat figures = new TableNumberFormat();
    List<List<String>> rows = new ArrayList<>();
    String family = "";
    for (PairwiseComparison pair : anova.comparisons()) {
      String heading = heading(pair);
      if (!heading.equals(family)) {
        family = heading;
        rows.add(List.of(heading));
      }
      boolean alone = pair.family().size() < 2;
      EffectSize d = pair.d();
      rows.add(
          List.of(
              pair.first() + " − " + pair.second(),
              figures.interval(pair.difference(), pair.low(), pair.high(), 3, CONSTANT),
              figures.number(pair.t(), 2, CONSTANT),
              figures.df(pair.df()),
              figures.p(pair.p(), CONSTANT),
              alone ? "" : figures.p(pair.holm(), CONSTANT),
              alone ? "" : figures.p(pair.bonferroni(), CONSTANT),
              alone || pair.tukey().isEmpty()
                  ? ""
                  : figures.p(pair.tukey().getAsDouble(), CONSTANT),
              figures.interval(d.value(), d.low(), d.high(), 2, CONSTANT),
              figures.p(pair.tost().p(), CONSTANT),
              figures.bayes(pair.bayesFactor(), CONSTANT)));
    }
    return new Table(
        "Comparisons: differences, TOST with bounds ±%s, Bayes factors"
            .formatted(figures.number(anova.bound(), 3)),
        List.of(
            "difference",
            "[95 % CI]",
            "t",
            "df",
            "p",
            "p (Holm)",
            "p (Bonf.)",
            "p (Tukey)",
            "d [95 % CI]",
            "p (TOST)",
            "BF01 (JZS)"),
        rows,
        figures.notes());
  }

  private static String heading(PairwiseComparison pair) {
    return pair.factor()
        + pair.at()
            .map(level -> " at " + level)
            .orElse(
                pair.factor().contains(" x ") ? ", differences of differences" : ", over all else");
  }
}
