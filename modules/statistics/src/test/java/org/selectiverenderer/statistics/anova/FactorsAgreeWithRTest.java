package org.selectiverenderer.statistics.anova;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.statistics.GoldenTable;
import org.selectiverenderer.statistics.assumption.AssumptionChecks;
import org.selectiverenderer.statistics.assumption.LeveneTest;
import org.selectiverenderer.statistics.assumption.ShapiroWilkTest;

/**
 * Holds designs of several factors and covariates, corrections for sphericity, corrections of
 * comparisons, intervals of d and the checks of assumptions against those of R's afex, car, emmeans
 * and effectsize for 60 random data sets; src/test/scripts/README.md tells how the files were made.
 */
class FactorsAgreeWithRTest {
  private static final double TOLERANCE = 1e-7;

  /** R's ptukey stops there. */
  private static final double TUKEY_TOLERANCE = 1e-6;

  @Test
  void everyFigureOfSixtyDesigns() throws IOException {
    Map<String, List<CSVRecord>> data = new LinkedHashMap<>();
    GoldenTable.read(FactorsAgreeWithRTest.class, "factors-data.csv.gz")
        .forEach(row -> data.computeIfAbsent(row.get("set"), set -> new ArrayList<>()).add(row));
    Map<String, Map<String, Double>> ours = new LinkedHashMap<>();
    data.forEach(
        (set, rows) -> ours.put(set, figures(Anova.of(design(rows), AnovaOptions.DEFAULT))));
    List<CSVRecord> golden = GoldenTable.read(FactorsAgreeWithRTest.class, "factors-golden.csv.gz");
    List<String> differences = new ArrayList<>();
    for (CSVRecord row : golden) {
      double theirs = Double.parseDouble(row.get("value"));
      Double value = Objects.requireNonNull(ours.get(row.get("set"))).get(row.get("key"));
      double tolerance = row.get("key").endsWith("tukey") ? TUKEY_TOLERANCE : TOLERANCE;
      if (value == null
          || !(Math.abs(value - theirs) <= tolerance * Math.max(1, Math.abs(theirs)))) {
        differences.add(row.get("set") + " " + row.get("key") + ": " + theirs + ", ours " + value);
      }
    }
    assertThat(ours).hasSize(60);
    assertThat(golden).hasSizeGreaterThan(8_000);
    assertThat(differences).isEmpty();
  }

  private static FactorialDesign design(List<CSVRecord> rows) {
    List<Factor> between = factors(rows, "a", "b");
    List<Factor> within = factors(rows, "u", "v");
    boolean covariate = !rows.get(0).get("x").isEmpty();
    int cells = Factor.crossed(within).levels().size();
    Map<String, Double[]> values = new LinkedHashMap<>();
    Map<String, CSVRecord> subjects = new LinkedHashMap<>();
    for (CSVRecord row : rows) {
      values.computeIfAbsent(row.get("subject"), id -> new Double[cells])[index(within, row)] =
          Double.valueOf(row.get("value"));
      subjects.put(row.get("subject"), row);
    }
    List<Subject> all = new ArrayList<>();
    subjects.forEach(
        (id, row) ->
            all.add(
                new Subject(
                    id,
                    index(between, row),
                    Arrays.asList(Objects.requireNonNull(values.get(id))),
                    covariate ? List.of(Double.valueOf(row.get("x"))) : List.of())));
    return new FactorialDesign("value", within, between, covariate ? List.of("x") : List.of(), all);
  }

  private static List<Factor> factors(List<CSVRecord> rows, String... names) {
    List<Factor> factors =
        Stream.of(names)
            .filter(name -> !rows.get(0).get(name).isEmpty())
            .map(
                name ->
                    new Factor(name, rows.stream().map(row -> row.get(name)).distinct().toList()))
            .toList();
    return factors.isEmpty() ? List.of(new Factor("none", List.of("all"))) : factors;
  }

  private static int index(List<Factor> factors, CSVRecord row) {
    int index = 0;
    for (Factor factor : factors) {
      index *= factor.levels().size();
      index += factor.varies() ? factor.levels().indexOf(row.get(factor.name())) : 0;
    }
    return index;
  }

  /** Everything under the keys of the script. */
  private static Map<String, Double> figures(Anova anova) {
    Map<String, Double> figures = new LinkedHashMap<>();
    effect(anova.intercept(), figures);
    anova.effects().forEach(effect -> effect(effect, figures));
    for (MarginalMean mean : anova.means()) {
      if (mean.levels().size() == 1) {
        String key = "mean|" + mean.levels().values().iterator().next() + "|";
        figures.put(key + "mean", mean.mean());
        figures.put(key + "se", mean.standardError());
      }
    }
    for (PairwiseComparison pair : anova.comparisons()) {
      if (pair.at().isEmpty() && !pair.factor().contains(" x ")) {
        pair(pair, figures);
      }
    }
    checks(anova, figures);
    return figures;
  }

  private static void effect(Effect effect, Map<String, Double> figures) {
    String key = "effect|" + effect.name() + "|";
    figures.put(key + "ss", effect.ss());
    figures.put(key + "error", effect.errorSs());
    figures.put(key + "df1", effect.df1());
    figures.put(key + "df2", effect.df2());
    figures.put(key + "F", effect.f());
    figures.put(key + "ges", effect.generalisedEta().value());
    figures.put(key + "p uncorrected", effect.uncorrectedP());
    figures.put(key + "p", effect.p());
    figures.put(key + "omega", effect.omega().value());
    figures.put(key + "low", effect.partialEta().low());
    figures.put(key + "high", effect.partialEta().high());
    Optional<Sphericity> sphericity = effect.sphericity();
    if (sphericity.isPresent()) {
      String at = "sphericity|" + effect.name() + "|";
      figures.put(at + "gg", sphericity.get().greenhouseGeisser());
      figures.put(at + "hf", sphericity.get().huynhFeldt());
      figures.put(at + "W", sphericity.get().mauchlyW());
    }
  }

  private static void pair(PairwiseComparison pair, Map<String, Double> figures) {
    String key = String.join("|", "pair", pair.factor(), pair.first(), pair.second()) + "|";
    figures.put(key + "difference", pair.difference());
    figures.put(key + "t", pair.t());
    figures.put(key + "p", pair.p());
    figures.put(key + "holm", pair.holm());
    figures.put(key + "bonferroni", pair.bonferroni());
    figures.put(key + "tukey", pair.tukey().orElseThrow());
    EffectSize d = pair.d();
    figures.put(key + "d", d.value());
    figures.put(key + "d low", d.low());
    figures.put(key + "d high", d.high());
  }

  private static void checks(Anova anova, Map<String, Double> figures) {
    AssumptionChecks found = AssumptionChecks.of(anova);
    for (int i = 0; i < found.levene().size(); i++) {
      LeveneTest test = found.levene().get(i);
      figures.put("levene|" + (i + 1) + "|F", test.f());
      figures.put("levene|" + (i + 1) + "|p", test.p());
    }
    for (int i = 0; i < found.shapiro().size(); i++) {
      ShapiroWilkTest test = found.shapiro().get(i);
      figures.put("shapiro|" + (i + 1) + "|W", test.w());
      figures.put("shapiro|" + (i + 1) + "|p", test.p());
    }
    for (int level = 0; level < anova.design().within().levels().size(); level++) {
      figures.put(
          "rstudent|" + (level + 1),
          Arrays.stream(anova.residuals().studentised(level)).map(Math::abs).max().orElseThrow());
    }
    found
        .box()
        .ifPresent(
            test -> {
              figures.put("box|m", test.m());
              figures.put("box|chi", test.chiSquared());
              figures.put("box|p", test.p());
            });
    found
        .welch()
        .ifPresent(
            test -> {
              figures.put("welch|F", test.f());
              figures.put("welch|df2", test.df2());
              figures.put("welch|p", test.p());
            });
  }
}
