package org.selectiverenderer.statistics.anova;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.statistics.GoldenTable;

/**
 * Holds every figure against those of R's afex, car, emmeans and BayesFactor for 200 random data
 * sets; src/test/scripts/README.md tells how the files were made.
 */
class AnovaAgreesWithRTest {
  private static final AnovaOptions OPTIONS =
      AnovaOptions.DEFAULT.withRawBound(0.5).withSphericity(SphericityCorrection.NONE);
  private static final double TOLERANCE = 1e-8;

  @Test
  void everyFigureOfTwoHundredDataSetsToOneInAHundredMillion() throws IOException {
    Map<String, List<CSVRecord>> data = new LinkedHashMap<>();
    GoldenTable.read(AnovaAgreesWithRTest.class, "anova-data.csv.gz")
        .forEach(row -> data.computeIfAbsent(row.get("set"), set -> new ArrayList<>()).add(row));
    Map<String, Map<String, Double>> ours = new LinkedHashMap<>();
    data.forEach((set, rows) -> ours.put(set, figures(Anova.of(design(rows), OPTIONS))));
    List<CSVRecord> golden = GoldenTable.read(AnovaAgreesWithRTest.class, "anova-golden.csv.gz");
    List<String> differences = new ArrayList<>();
    for (CSVRecord row : golden) {
      double theirs = Double.parseDouble(row.get("value"));
      Double value = Objects.requireNonNull(ours.get(row.get("set"))).get(row.get("key"));
      if (value == null
          || !(Math.abs(value - theirs) <= TOLERANCE * Math.max(1, Math.abs(theirs)))) {
        differences.add(row.get("set") + " " + row.get("key") + ": " + theirs + ", ours " + value);
      }
    }
    assertThat(ours).hasSize(200);
    assertThat(golden).hasSizeGreaterThan(45_000);
    assertThat(differences).isEmpty();
  }

  private static FactorialDesign design(List<CSVRecord> rows) {
    List<String> groups = rows.stream().map(row -> row.get("group")).distinct().toList();
    List<String> levels = rows.stream().map(row -> row.get("level")).distinct().toList();
    Map<String, List<CSVRecord>> subjects = new LinkedHashMap<>();
    rows.forEach(
        row -> subjects.computeIfAbsent(row.get("subject"), id -> new ArrayList<>()).add(row));
    return new FactorialDesign(
        "value",
        new Factor("level", levels),
        new Factor("group", groups),
        subjects.values().stream().map(of -> subject(of, groups, levels)).toList());
  }

  private static Subject subject(List<CSVRecord> rows, List<String> groups, List<String> levels) {
    Double[] values = new Double[levels.size()];
    rows.forEach(
        row -> values[levels.indexOf(row.get("level"))] = Double.valueOf(row.get("value")));
    return new Subject(
        rows.get(0).get("subject"), groups.indexOf(rows.get(0).get("group")), List.of(values));
  }

  /** Everything under the keys of the script. */
  private static Map<String, Double> figures(Anova anova) {
    Map<String, Double> figures = new LinkedHashMap<>();
    effect(anova.intercept(), figures);
    anova.effects().forEach(effect -> effect(effect, figures));
    for (MarginalMean mean : anova.means()) {
      String key = "mean|" + mean.between().orElse("") + "|" + mean.within().orElse("") + "|";
      figures.put(key + "mean", mean.mean());
      figures.put(key + "se", mean.standardError());
      figures.put(key + "low", mean.low());
      figures.put(key + "high", mean.high());
    }
    for (PairwiseComparison pair : anova.comparisons()) {
      String key =
          String.join("|", "pair", pair.factor(), pair.at().orElse(""), pair.first(), pair.second())
              + "|";
      figures.put(key + "difference", pair.difference());
      figures.put(key + "se", pair.standardError());
      figures.put(key + "low", pair.low());
      figures.put(key + "high", pair.high());
      figures.put(key + "t", pair.t());
      figures.put(key + "p", pair.p());
      figures.put(key + "holm", pair.holm());
      figures.put(key + "tost", pair.tost().p());
      figures.put("jzs", pair.bayesFactor());
    }
    return figures;
  }

  private static void effect(Effect effect, Map<String, Double> figures) {
    String key = "effect|" + effect.name() + "|";
    figures.put(key + "ss", effect.ss());
    figures.put(key + "error", effect.errorSs());
    figures.put(key + "df1", effect.df1());
    figures.put(key + "df2", effect.df2());
    figures.put(key + "F", effect.f());
    figures.put(key + "p", effect.p());
    figures.put(key + "pes", effect.partialEta().value());
    figures.put(key + "ges", effect.generalisedEta().value());
    figures.put(key + "low", effect.partialEta().low());
    figures.put(key + "high", effect.partialEta().high());
    figures.put(key + "equivalence", effect.equivalence().p());
    Optional<Sphericity> sphericity = effect.sphericity();
    if (sphericity.isPresent()) {
      String at = "sphericity|" + effect.name() + "|";
      figures.put(at + "gg", sphericity.get().greenhouseGeisser());
      figures.put(at + "hf", sphericity.get().huynhFeldt());
      figures.put(at + "gg p", effect.correctedP(sphericity.get().greenhouseGeisser()));
      figures.put(at + "hf p", effect.correctedP(sphericity.get().huynhFeldt()));
      figures.put(at + "W", sphericity.get().mauchlyW());
      figures.put(at + "W p", sphericity.get().mauchlyP());
    }
    for (MultivariateTest test : effect.multivariate()) {
      String name =
          switch (test.statistic()) {
            case PILLAI -> "Pillai";
            case WILKS -> "Wilks";
            case HOTELLING -> "HL";
            case ROY -> "Roy";
          };
      String at = name + "|" + effect.name() + "|";
      figures.put(at + "value", test.value());
      figures.put(at + "F", test.f());
      figures.put(at + "df1", test.df1());
      figures.put(at + "df2", test.df2());
      figures.put(at + "p", test.p());
    }
  }
}
