package org.selectiverenderer.statistics.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.statistics.anova.AnovaOptions;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.detection.DetectionScorer;
import org.selectiverenderer.statistics.detection.ExtremeRateCorrection;
import org.selectiverenderer.statistics.detection.LowConfidencePolicy;
import org.selectiverenderer.statistics.study.AreaAnalyser;

/** Holds the power by formula against R, and against simulation. */
class AnalyticPowerTest {
  private static final String INTERACTION = AreaAnalyser.WITHIN + " x " + AreaAnalyser.BETWEEN;

  @Test
  void everyPowerIsThatOfR() throws IOException {
    int compared = 0;
    for (CSVRecord row : golden()) {
      Map<String, Double> found =
          AnalyticPower.of(analysis(row, 1), Integer.parseInt(row.get("participants")));
      Map<String, String> columns =
          Map.of(
              AreaAnalyser.BETWEEN,
              "condition",
              AreaAnalyser.WITHIN,
              "type",
              INTERACTION,
              "interaction");
      for (var column : columns.entrySet()) {
        String theirs = row.get(column.getValue());
        if (theirs.isEmpty()) {
          assertThat(found).doesNotContainKey(column.getKey());
        } else {
          compared++;
          assertThat(found.get(column.getKey()))
              .as("%s of %s", column.getKey(), row)
              .isEqualTo(Double.parseDouble(theirs), within(1e-6));
        }
      }
    }
    assertThat(compared).isEqualTo(48 * 3 - 24);
  }

  /** 400 studies: the standard error of a share is at most 0.025. */
  @Test
  void simulationFindsTheSamePower() throws IOException {
    CSVRecord row =
        golden().stream()
            .filter(own -> own.get("d").equals("0.7 1.4 1"))
            .filter(own -> own.get("participants").equals("54"))
            .filter(own -> own.get("measure").equals("d_prime"))
            .findFirst()
            .orElseThrow();
    PowerAnalysis analysis = analysis(row, 400);
    PowerEstimate simulated = analysis.power(54);
    Map<String, Double> formula = AnalyticPower.of(analysis, 54);
    assertThat(formula.get(AreaAnalyser.BETWEEN)).isBetween(0.5, 0.999);
    formula.forEach(
        (name, power) -> assertThat(simulated.share(name)).as(name).isEqualTo(power, within(0.07)));
  }

  @Test
  void thereIsNoFormulaWhereScoresMayBeInfinite() throws IOException {
    PowerAnalysis analysis = analysis(golden().get(0), 1);
    PowerAnalysis uncorrected =
        new PowerAnalysis(
            analysis.model(),
            analysis.area(),
            analysis.measure(),
            new DetectionScorer(ExtremeRateCorrection.NONE, LowConfidencePolicy.DISCARD),
            analysis.options(),
            1,
            1,
            line -> {});
    assertThat(AnalyticPower.of(uncorrected, 54)).isEmpty();
  }

  private static PowerAnalysis analysis(CSVRecord row, int studies) {
    List<Double> sensitivities = numbers(row.get("d"));
    SimulationModel model =
        new SimulationModel(
            List.of("high", "high-low", "selective").subList(0, sensitivities.size()),
            sensitivities,
            numbers(row.get("c")),
            Double.parseDouble(row.get("d_sd")),
            Double.parseDouble(row.get("c_sd")),
            Double.parseDouble(row.get("type_d")),
            Double.parseDouble(row.get("type_c")),
            RecognitionListSpec.THESIS);
    return new PowerAnalysis(
        model,
        row.get("area"),
        Stream.of(DetectionMeasure.values())
            .filter(measure -> measure.key().equals(row.get("measure")))
            .findFirst()
            .orElseThrow(),
        new DetectionScorer(
            row.get("correction").equals("half")
                ? ExtremeRateCorrection.HALF_TRIAL
                : ExtremeRateCorrection.LOG_LINEAR,
            LowConfidencePolicy.DISCARD),
        AnovaOptions.DEFAULT,
        studies,
        5,
        line -> {});
  }

  private static List<Double> numbers(String text) {
    return Stream.of(text.split(" ")).map(Double::valueOf).toList();
  }

  private static List<CSVRecord> golden() throws IOException {
    try (InputStream in =
            Objects.requireNonNull(
                AnalyticPowerTest.class.getResourceAsStream("power-golden.csv"));
        var text = new InputStreamReader(in, StandardCharsets.UTF_8)) {
      return CSVFormat.DEFAULT
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .get()
          .parse(text)
          .getRecords();
    }
  }
}
