package org.selectiverenderer.statistics.detection;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.junit.jupiter.api.Test;

/**
 * Holds the area under the ROC against R's pROC and the fit of two normal distributions against R's
 * optim and nlm; src/test/scripts/README.md tells how the files were made.
 */
class RatingAgreesWithRTest {
  /**
   * R's search by differences ends at 1e-6 of a parameter or so; its likelihood is exact to more.
   */
  private static final double ESTIMATE = 2e-5;

  private static final double CLOSED_FORM = 1e-9;

  @Test
  void everyFigureOfThirtySixTables() throws IOException {
    Map<String, Map<String, Double>> ours = new LinkedHashMap<>();
    for (CSVRecord row : read("ratings-data.csv")) {
      ours.put(
          row.get("set"),
          figures(new RatingCounts(counts(row.get("noise")), counts(row.get("signal")))));
    }
    assertThat(ours).hasSize(36);
    List<CSVRecord> golden = read("ratings-golden.csv");
    assertThat(golden).hasSizeGreaterThan(900);
    List<String> differences = new ArrayList<>();
    for (CSVRecord row : golden) {
      double theirs = Double.parseDouble(row.get("value"));
      Double value = Objects.requireNonNull(ours.get(row.get("set"))).get(row.get("key"));
      double tolerance = row.get("key").startsWith("auc") ? CLOSED_FORM : ESTIMATE;
      if (value == null
          || !(Math.abs(value - theirs) <= tolerance * Math.max(1, Math.abs(theirs)))) {
        differences.add(row.get("set") + " " + row.get("key") + ": " + theirs + ", ours " + value);
      }
    }
    assertThat(differences).isEmpty();
  }

  private static Map<String, Double> figures(RatingCounts ratings) {
    Map<String, Double> figures = new HashMap<>();
    EmpiricalRoc roc = EmpiricalRoc.of(ratings);
    figures.put("auc", roc.area());
    figures.put("auc_se", roc.standardError());
    UnequalVarianceFit fit = UnequalVarianceFit.of(ratings);
    assertThat(fit.flaw()).isEmpty();
    put(figures, "a", fit.intercept());
    put(figures, "b", fit.slope());
    put(figures, "d_a", fit.distance());
    put(figures, "a_z", fit.area());
    for (int i = 0; i < fit.criteria().size(); i++) {
      put(figures, "c" + (i + 1), fit.criteria().get(i));
    }
    figures.put("g2", fit.g2());
    figures.put("df", (double) fit.df());
    figures.put("g2_p", fit.fitP());
    figures.put("slope_p", fit.slopeP());
    put(figures, "equal_d", fit.equal().orElseThrow().dPrime());
    figures.put("equal_g2", fit.equal().orElseThrow().g2());
    return figures;
  }

  private static void put(
      Map<String, Double> figures, String key, UnequalVarianceFit.Estimate estimate) {
    figures.put(key, estimate.value());
    figures.put(key + "_se", estimate.standardError());
  }

  private static List<Integer> counts(String text) {
    return Stream.of(text.split(" ")).map(Integer::valueOf).toList();
  }

  private static List<CSVRecord> read(String name) throws IOException {
    try (InputStream file =
            Objects.requireNonNull(RatingAgreesWithRTest.class.getResourceAsStream(name));
        InputStreamReader text = new InputStreamReader(file, StandardCharsets.UTF_8)) {
      return CSVFormat.RFC4180
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .get()
          .parse(text)
          .getRecords();
    }
  }
}
