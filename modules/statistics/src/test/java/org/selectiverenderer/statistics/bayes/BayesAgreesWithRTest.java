package org.selectiverenderer.statistics.bayes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.statistics.GoldenTable;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.anova.EffectPrior;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.data.DataSource;
import org.selectiverenderer.statistics.data.Responses;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.simulation.RecognitionListSpec;
import org.selectiverenderer.statistics.simulation.SimulationModel;
import org.selectiverenderer.statistics.simulation.StudySimulator;
import org.selectiverenderer.statistics.study.AreaAnalyser;

/**
 * Holds Bayes factors of effects against R's BayesFactor, and against a brute-force integral in R
 * that takes nothing apart; src/test/scripts/README.md tells how the files were made.
 */
class BayesAgreesWithRTest {
  /** Brute force has steps as wide as patience allows. */
  private static final double EXACT = 1e-4;

  /** BayesFactor's Monte Carlo, whose own estimate of its error is itself uncertain. */
  private static final double SAMPLED = 0.01;

  private static final double ERRORS = 4;

  @Test
  void everyBayesFactorOfRandomDesigns() throws IOException {
    Map<String, List<CSVRecord>> data = new LinkedHashMap<>();
    GoldenTable.read(BayesAgreesWithRTest.class, "bayes-data.csv.gz")
        .forEach(row -> data.computeIfAbsent(row.get("set"), set -> new ArrayList<>()).add(row));
    Map<String, EffectBayesFactors> ours = new LinkedHashMap<>();
    data.forEach(
        (set, rows) ->
            new BayesianAnova(Anova.of(design(rows), AnovaOptions.DEFAULT))
                .effects()
                .forEach(found -> ours.put(set + " " + found.term().name(), found)));
    List<String> differences = new ArrayList<>();
    int compared = 0;
    for (CSVRecord row : GoldenTable.read(BayesAgreesWithRTest.class, "bayes-golden.csv.gz")) {
      if (row.get("set").equals("0")) {
        continue;
      }
      String key = row.get("set") + " " + row.get("effect");
      EffectBayesFactors found = Objects.requireNonNull(ours.get(key), key);
      double theirs = Double.parseDouble(row.get("bf01"));
      double error = Double.parseDouble(row.get("error"));
      double allowed =
          (row.get("from").equals("lmBF") ? SAMPLED + ERRORS * error : EXACT)
              + ERRORS * found.error();
      if (!(Math.abs(Math.log(found.bf01() / theirs)) <= allowed)) {
        differences.add(
            "%s %s: %s ± %s, ours %s".formatted(key, row.get("from"), theirs, error, found.bf01()));
      }
      compared++;
    }
    assertThat(compared).isGreaterThan(45);
    assertThat(differences).isEmpty();
  }

  /**
   * The worked example of docs/statistics.md: {@code anovaBF(d_prime ~ condition * type + id,
   * whichRandom = "id", iterations = 200000)} has 0.12229 ± 0.3 % for the condition alone, 7.0413
   * for the type, and 0.89612 ± 0.9 % for both.
   */
  @Test
  void theShippedExamplesCondition() {
    SimulationModel model =
        new SimulationModel(
            List.of("high", "high-low", "selective"),
            List.of(1.1, 1.1, 1.1),
            List.of(0.0, 0.0, 0.0),
            0.3,
            0.25,
            0,
            0.4,
            RecognitionListSpec.THESIS);
    Responses responses =
        new Responses(
            DataSource.none("simulated"), StudySimulator.responses(model, 54, 2009), List.of());
    Anova anova =
        AreaAnalyser.of(responses, DetectionScorer.DEFAULT, "kitchen")
            .analysis(ConfidenceThreshold.ALL, DetectionMeasure.D_PRIME, AnovaOptions.DEFAULT)
            .anova()
            .orElseThrow();
    assertThat(anova.effects().get(0).f()).isEqualTo(0.028, within(0.0005));
    EffectBayesFactors condition = new BayesianAnova(anova).effects().get(0);
    assertThat(condition.alone().bf01()).isEqualTo(1 / 0.1222936, within(0.08));
    assertThat(condition.bf01()).isEqualTo(7.0413115 / 0.8961229, within(0.25));
  }

  /**
   * A large other effect is not taken for error. {@code anovaBF(y ~ A * B, rscaleFixed = 0.5,
   * iterations = 200000)} has 0.5493748 for A, 31978.118 for B, and 54080.442 ± 0.5 % for both.
   */
  @Test
  void theHeadlineIsBesideTheOtherEffects() {
    double[] noise = {0.3, -0.8, 1.1, -0.4};
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < 6; group++) {
      for (double own : noise) {
        double value = own + 0.7 * (group / 3) + 3 * (group % 3 / 2);
        subjects.add(new Subject("s" + subjects.size(), group, List.of(value)));
      }
    }
    FactorialDesign design =
        new FactorialDesign(
            "y",
            List.of(new Factor("none", List.of("all"))),
            List.of(new Factor("A", List.of("0", "1")), new Factor("B", List.of("0", "1", "2"))),
            List.of(),
            subjects);
    EffectBayesFactors a =
        new BayesianAnova(Anova.of(design, AnovaOptions.DEFAULT)).effects().get(0);
    assertThat(a.bf01()).isEqualTo(31978.118 / 54080.442, within(0.012));
    assertThat(a.alone().bf01()).isEqualTo(1 / 0.5493748, within(1e-3));
  }

  /** F alone: data of equal groups that have it. {@code oneWayAOV.Fstat(F, N, J, rscale = 0.5)}. */
  @Test
  void fOfEqualGroups() throws IOException {
    int compared = 0;
    for (CSVRecord row : GoldenTable.read(BayesAgreesWithRTest.class, "bayes-golden.csv.gz")) {
      if (row.get("set").equals("0")) {
        String[] parts = row.get("effect").replaceAll("[F()]", "").split(";");
        FactorialDesign design =
            equalGroups(
                Double.parseDouble(parts[0]),
                Integer.parseInt(parts[1]),
                Integer.parseInt(parts[2]));
        Anova anova = Anova.of(design, AnovaOptions.DEFAULT);
        assertThat(anova.effects().get(0).f())
            .isEqualTo(Double.parseDouble(parts[0]), within(1e-9));
        double theirs = Double.parseDouble(row.get("bf01"));
        assertThat(new BayesianAnova(anova).effects().get(0).bf01() / theirs)
            .isEqualTo(1, within(1e-5));
        compared++;
      }
    }
    assertThat(compared).isEqualTo(5);
  }

  /**
   * The wider the prior, the more it speaks for the null where there is no effect, and the curve
   * goes through the width asked for. {@code 1 / exp(oneWayAOV.Fstat(0.576, 18, 3, rscale =
   * r)$bf)}.
   */
  @ParameterizedTest
  @CsvSource({"0.2, 1.975571", "0.5, 4.546136", "1, 12.34605"})
  void thePriorsWidthIsAnOption(double width, double bf01) {
    FactorialDesign design = equalGroups(0.576, 18, 3);
    EffectPrior prior = EffectPrior.MEDIUM.withFixed(width);
    EffectBayesFactors found =
        new BayesianAnova(Anova.of(design, AnovaOptions.DEFAULT.withPrior(prior)))
            .withRobustness()
            .get(0);
    assertThat(found.bf01()).isEqualTo(bf01, within(bf01 * 1e-6));
    assertThat(found.robustness())
        .isSortedAccordingTo((a, b) -> Double.compare(a.bf01(), b.bf01()));
    assertThat(found.robustness())
        .filteredOn(point -> point.scale() == 0.5)
        .singleElement()
        .satisfies(point -> assertThat(point.bf01()).isEqualTo(4.546136, within(1e-4)));
  }

  @Test
  void aSampledIntegralIsTheSameForASeedAndTellsItsError() {
    List<Subject> subjects = new ArrayList<>();
    int[] groups = {0, 0, 1, 1, 1, 2, 2, 3, 3, 3, 3, 0, 2, 3};
    for (int i = 0; i < groups.length; i++) {
      subjects.add(new Subject("s" + i, groups[i], List.of(Math.sin(3.0 * i) + groups[i] * 0.2)));
    }
    FactorialDesign design =
        new FactorialDesign(
            "y",
            List.of(new Factor("none", List.of("all"))),
            List.of(new Factor("a", List.of("1", "2")), new Factor("b", List.of("1", "2"))),
            List.of(),
            subjects);
    EffectBayesFactors once = interaction(design, 1);
    assertThat(interaction(design, 1)).isEqualTo(once);
    assertThat(once.error()).isBetween(1e-6, 0.01);
    EffectBayesFactors other = interaction(design, 2);
    assertThat(other.bf01()).isNotEqualTo(once.bf01());
    assertThat(other.bf01() / once.bf01())
        .isEqualTo(1, within(6 * once.error() + 6 * other.error()));
  }

  @Test
  void aDesignWithCovariatesSaysThatItHasNone() {
    List<Subject> subjects = new ArrayList<>();
    for (int i = 0; i < 9; i++) {
      subjects.add(
          new Subject("s" + i, i % 2, List.of(Math.sin(2.0 * i)), List.of(Math.cos(5.0 * i))));
    }
    FactorialDesign design =
        new FactorialDesign(
            "y",
            List.of(new Factor("none", List.of("all"))),
            List.of(new Factor("a", List.of("1", "2"))),
            List.of("age"),
            subjects);
    Anova anova = Anova.of(design, AnovaOptions.DEFAULT);
    assertThat(BayesianAnova.obstacle(anova))
        .hasValueSatisfying(why -> assertThat(why).contains("covariates"));
    assertThat(new BayesianAnova(anova).effects())
        .allSatisfy(found -> assertThat(found.bf01()).isNaN());
  }

  private static EffectBayesFactors interaction(FactorialDesign design, long seed) {
    EffectPrior prior = new EffectPrior(0.5, 1, seed);
    return new BayesianAnova(Anova.of(design, AnovaOptions.DEFAULT.withPrior(prior)))
        .effects()
        .get(2);
  }

  private static FactorialDesign equalGroups(double f, int size, int groups) {
    List<Subject> subjects = new ArrayList<>();
    double inside = 0;
    double outside = 0;
    for (int i = 0; i < size; i++) {
      inside += groups * Math.pow(i - (size - 1) / 2.0, 2);
    }
    for (int group = 0; group < groups; group++) {
      outside += size * Math.pow(group - (groups - 1) / 2.0, 2);
    }
    double ms = inside / (groups * (size - 1.0));
    double scale = Math.sqrt(f * ms * (groups - 1) / outside);
    List<String> names = new ArrayList<>();
    for (int group = 0; group < groups; group++) {
      names.add("g" + group);
      for (int i = 0; i < size; i++) {
        subjects.add(new Subject(group + "-" + i, group, List.of(i + scale * group)));
      }
    }
    return new FactorialDesign(
        "y", new Factor("level", List.of("all")), new Factor("group", names), subjects);
  }

  private static FactorialDesign design(List<CSVRecord> rows) {
    List<Factor> between = factors(rows, "a", "b");
    List<Factor> within = factors(rows, "u");
    Map<String, List<Double>> values = new LinkedHashMap<>();
    Map<String, Integer> groups = new LinkedHashMap<>();
    for (CSVRecord row : rows) { // ordered by level within subjects
      values
          .computeIfAbsent(row.get("subject"), id -> new ArrayList<>())
          .add(Double.valueOf(row.get("value")));
      int group = 0;
      for (Factor factor : between) {
        group *= factor.levels().size();
        group += factor.varies() ? factor.levels().indexOf(row.get(factor.name())) : 0;
      }
      groups.put(row.get("subject"), group);
    }
    List<Subject> subjects = new ArrayList<>();
    values.forEach(
        (id, own) -> subjects.add(new Subject(id, Objects.requireNonNull(groups.get(id)), own)));
    return new FactorialDesign("value", within, between, List.of(), subjects);
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
}
