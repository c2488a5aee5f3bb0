package org.selectiverenderer.app.replication;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.Effect;
import org.selectiverenderer.statistics.anova.EffectKind;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.MultivariateStatistic;
import org.selectiverenderer.statistics.anova.MultivariateTest;
import org.selectiverenderer.statistics.anova.Subject;

/**
 * Recomputes Figs 93, 94, 97 and 98 from Figs 92 and 96. An analysis of variance of balanced groups
 * depends on the data by their means, standard deviations and covariances only; so data that are
 * built to have those of print have its F, whatever the participants' own scores were.
 */
final class KitchenRecomputation {
  private static final List<String> TYPES = List.of("consistent", "inconsistent");
  private static final List<String> GROUPS = List.of("high", "high-low", "selective");

  private KitchenRecomputation() {}

  /**
   * A printed number with what comes out.
   *
   * @param computed as many decimals as are printed
   */
  record Row(ThesisTables.KitchenFigure figure, String computed) {
    boolean same() {
      return figure.printed().equals(computed);
    }
  }

  static List<Row> rows() {
    List<Row> rows = new ArrayList<>();
    for (String measure : List.of("dprime", "logbeta")) {
      Anova anova = anova(measure);
      for (ThesisTables.KitchenFigure figure : ThesisTables.kitchenFigures()) {
        if (figure.measure().equals(measure)) {
          rows.add(new Row(figure, rounded(value(anova, figure), figure.printed())));
        }
      }
    }
    return rows;
  }

  /** Returns the mean square that the thesis's text to Fig 94 prints for F. */
  static double meanSquareOfGroups() {
    return anova("dprime").effect(EffectKind.BETWEEN).orElseThrow().ms();
  }

  private static double value(Anova anova, ThesisTables.KitchenFigure figure) {
    Effect effect =
        switch (figure.effect()) {
          case "intercept" -> anova.intercept();
          case "group", "error" -> anova.effect(EffectKind.BETWEEN).orElseThrow();
          case "object type" -> anova.effect(EffectKind.WITHIN).orElseThrow();
          default -> anova.effect(EffectKind.INTERACTION).orElseThrow();
        };
    boolean error = figure.effect().equals("error");
    return switch (figure.statistic()) {
      case "ss" -> error ? effect.errorSs() : effect.ss();
      case "ms" -> error ? effect.errorMs() : effect.ms();
      case "F" -> effect.f();
      case "p" -> effect.p();
      default -> multivariate(effect, figure.statistic());
    };
  }

  private static double multivariate(Effect effect, String name) {
    MultivariateStatistic wanted =
        switch (name) {
          case "pillai" -> MultivariateStatistic.PILLAI;
          case "wilks" -> MultivariateStatistic.WILKS;
          case "hotelling" -> MultivariateStatistic.HOTELLING;
          default -> MultivariateStatistic.ROY;
        };
    return effect.multivariate().stream()
        .filter(test -> test.statistic() == wanted)
        .mapToDouble(MultivariateTest::value)
        .findFirst()
        .orElse(Double.NaN);
  }

  private static String rounded(double value, String printed) {
    int decimals = printed.contains(".") ? printed.length() - printed.indexOf('.') - 1 : 0;
    return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString();
  }

  private static Anova anova(String measure) {
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < GROUPS.size(); group++) {
      ThesisTables.KitchenCell first = cell(measure, TYPES.get(0), GROUPS.get(group));
      ThesisTables.KitchenCell second = cell(measure, TYPES.get(1), GROUPS.get(group));
      int n = first.n();
      // Cosine and sine over whole turns have mean 0, the same deviation, and no correlation.
      double deviation = Math.sqrt(n / (2.0 * (n - 1)));
      double slope = first.covariance() / first.sd();
      double rest = Math.sqrt(second.sd() * second.sd() - slope * slope);
      for (int i = 0; i < n; i++) {
        double a = Math.cos(2 * Math.PI * i / n) / deviation;
        double b = Math.sin(2 * Math.PI * i / n) / deviation;
        subjects.add(
            new Subject(
                GROUPS.get(group) + "-" + i,
                group,
                List.of(first.mean() + first.sd() * a, second.mean() + slope * a + rest * b)));
      }
    }
    return Anova.of(
        new FactorialDesign(
            measure, new Factor("object type", TYPES), new Factor("group", GROUPS), subjects),
        AnovaOptions.DEFAULT);
  }

  private static ThesisTables.KitchenCell cell(String measure, String type, String group) {
    Optional<ThesisTables.KitchenCell> found =
        ThesisTables.kitchenMeans().stream()
            .filter(cell -> cell.measure().equals(measure))
            .filter(cell -> cell.type().equals(type) && cell.group().equals(group))
            .findFirst();
    return found.orElseThrow();
  }
}
