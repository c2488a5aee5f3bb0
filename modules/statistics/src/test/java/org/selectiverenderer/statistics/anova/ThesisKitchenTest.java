package org.selectiverenderer.statistics.anova;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVRecord;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.stat.descriptive.moment.Mean;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Data that have the means and standard deviations of the thesis's Figs 92 and 96 to the printed
 * digits, and the covariance that the printed error terms imply, give every figure of Figs 93, 94,
 * 97 and 98.
 */
class ThesisKitchenTest {
  private static final List<String> GROUPS = List.of("high", "high-low", "selective");
  private static final List<String> LEVELS = List.of("consistent", "inconsistent");

  @ParameterizedTest
  @ValueSource(strings = {"dprime", "logbeta"})
  void constructedDataHaveThePrintedMeansAndDeviations(String measure) throws IOException {
    Anova anova = anova(measure);
    for (CSVRecord row : rows("kitchen-means.csv", measure)) {
      CellDescriptives cell =
          anova.descriptives().stream()
              .filter(found -> found.within().orElseThrow().equals(row.get("level")))
              .filter(found -> found.between().orElse("").equals(row.get("group")))
              .findFirst()
              .orElseThrow();
      assertThat(rounded(cell.mean(), 4)).isEqualTo(row.get("mean"));
      assertThat(rounded(cell.sd(), 5)).isEqualTo(row.get("sd"));
      assertThat(cell.n()).isEqualTo(18);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"dprime", "logbeta"})
  void everyPrintedFigureComesOut(String measure) throws IOException {
    Anova anova = anova(measure);
    for (CSVRecord row : rows("kitchen-results.csv", measure)) {
      if (row.get("effect").equals("error")) {
        Effect group = anova.effect(EffectKind.BETWEEN).orElseThrow();
        assertPrinted(row, "ss", group.errorSs());
        assertPrinted(row, "df1", group.df2());
        assertPrinted(row, "ms", group.errorMs());
        continue;
      }
      Effect effect =
          row.get("effect").equals("intercept")
              ? anova.intercept()
              : anova.effects().stream()
                  .filter(found -> found.name().equals(row.get("effect")))
                  .findFirst()
                  .orElseThrow();
      assertPrinted(row, "ss", effect.ss());
      assertPrinted(row, "df1", effect.df1());
      assertPrinted(row, "df2", effect.df2());
      assertPrinted(row, "ms", effect.ms());
      assertPrinted(row, "F", effect.f());
      assertPrinted(row, "p", effect.p());
      for (MultivariateTest test : effect.multivariate()) {
        String column =
            switch (test.statistic()) {
              case PILLAI -> "pillai";
              case WILKS -> "wilks";
              case HOTELLING -> "hotelling";
              case ROY -> "roy";
            };
        assertPrinted(row, column, test.value());
        assertPrinted(row, "F", test.f());
        assertPrinted(row, "p", test.p());
        assertThat(test.exact()).isTrue();
      }
    }
  }

  /** "F(2,51) = 0.560": the thesis's text to Fig 94 prints the mean square for F. */
  @Test
  void theTextsSlipAtFig94IsTheMeanSquare() throws IOException {
    Effect group = anova("dprime").effect(EffectKind.BETWEEN).orElseThrow();
    assertThat(rounded(group.ms(), 3)).isEqualTo("0.560");
    assertThat(rounded(group.f(), 3)).isEqualTo("2.317");
    assertThat(rounded(group.p(), 3)).isEqualTo("0.109");
  }

  private static void assertPrinted(CSVRecord row, String column, double value) {
    String printed = row.get(column);
    if (!printed.isEmpty()) {
      int decimals = printed.contains(".") ? printed.length() - printed.indexOf('.') - 1 : 0;
      assertThat(rounded(value, decimals))
          .as("%s of %s, Fig %s", column, row.get("effect"), row.get("figure"))
          .isEqualTo(printed);
    }
  }

  private static String rounded(double value, int decimals) {
    return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString();
  }

  private static Anova anova(String measure) throws IOException {
    List<CSVRecord> cells = rows("kitchen-constructed.csv", measure);
    List<Subject> subjects = new ArrayList<>();
    for (int group = 0; group < GROUPS.size(); group++) {
      String name = GROUPS.get(group);
      List<CSVRecord> own = cells.stream().filter(cell -> cell.get("group").equals(name)).toList();
      subjects.addAll(subjects(group, own.get(0), own.get(1)));
    }
    return Anova.of(
        new FactorialDesign(
            measure, new Factor("object type", LEVELS), new Factor("group", GROUPS), subjects),
        AnovaOptions.DEFAULT);
  }

  /** Two series without correlation, of mean 0 and deviation 1, given the wanted covariance. */
  private static List<Subject> subjects(int group, CSVRecord first, CSVRecord second) {
    double covariance = Double.parseDouble(first.get("covariance"));
    int n = Integer.parseInt(first.get("n"));
    double[] a = new double[n];
    double[] b = new double[n];
    for (int i = 0; i < n; i++) {
      a[i] = Math.cos(2 * Math.PI * i / n);
      b[i] = Math.sin(2 * Math.PI * i / n);
    }
    double sd1 = Double.parseDouble(first.get("sd"));
    double sd2 = Double.parseDouble(second.get("sd"));
    RealMatrix l =
        new CholeskyDecomposition(
                MatrixUtils.createRealMatrix(
                    new double[][] {{sd1 * sd1, covariance}, {covariance, sd2 * sd2}}))
            .getL();
    standardise(a);
    standardise(b);
    List<Subject> subjects = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      double x = Double.parseDouble(first.get("mean")) + l.getEntry(0, 0) * a[i];
      double y =
          Double.parseDouble(second.get("mean"))
              + l.getEntry(1, 0) * a[i]
              + l.getEntry(1, 1) * b[i];
      subjects.add(new Subject(group + "-" + i, group, List.of(x, y)));
    }
    return subjects;
  }

  private static void standardise(double[] values) {
    double mean = new Mean().evaluate(values);
    double sd = new StandardDeviation().evaluate(values);
    for (int i = 0; i < values.length; i++) {
      values[i] = (values[i] - mean) / sd;
    }
  }

  private static List<CSVRecord> rows(String name, String measure) throws IOException {
    try (InputStream file =
        Objects.requireNonNull(ThesisKitchenTest.class.getResourceAsStream(name))) {
      return CSVFormat.RFC4180
          .builder()
          .setHeader()
          .setSkipHeaderRecord(true)
          .get()
          .parse(new InputStreamReader(file, StandardCharsets.UTF_8))
          .stream()
          .filter(row -> row.get("measure").equals(measure))
          .toList();
    }
  }
}
