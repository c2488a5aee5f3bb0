package org.selectiverenderer.app.replication;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.simulation.ScoreTarget;

/** Reads what the thesis prints, as typed in from it. */
final class ThesisTables {
  private static final List<String> LEVELS = List.of("un", "mod", "high");

  private ThesisTables() {}

  /**
   * A count of Tables 3 to 5.
   *
   * @param schemas schemas that are active, joined by {@code +}; empty for all objects high
   * @param recomputed the sum of the objects that the thesis lists
   * @param note what is wrong in print; empty for nothing
   */
  record PolygonTotal(
      String table, String area, String schemas, long printed, long recomputed, String note) {}

  /**
   * A row of Tables 6 to 11.
   *
   * @param type consistent, inconsistent, or neutral where the table has all objects together
   * @param objects the O of the table
   * @param condition {@code total} for all conditions together
   * @param levels means and standard deviations at the three levels of confidence
   */
  record ScoreRow(
      String area, String type, int objects, String condition, List<ScoreTarget> levels) {
    static final String TOTAL = "total";

    boolean total() {
      return condition.equals(TOTAL);
    }

    /** Returns the number of the table. */
    int table() {
      return 6 + List.of("kitchen", "office", "desk", "bookcase", "lounge", "sofa").indexOf(area);
    }
  }

  /** A cell of Figs 92 and 96, with the covariance of its two types of objects. */
  record KitchenCell(
      String measure,
      String type,
      String group,
      double mean,
      double sd,
      int n,
      double covariance) {}

  /** A number of Figs 93 to 98. */
  record KitchenFigure(
      String measure, String figure, String effect, String statistic, String printed) {}

  /** A test that the thesis's text tells. */
  record PrintedEffect(
      String area,
      ConfidenceThreshold level,
      DetectionMeasure measure,
      String effect,
      double f,
      int df1,
      int df2,
      String source) {}

  static List<PolygonTotal> polygons() {
    return rows("tables-3-5.csv")
        .map(
            row ->
                new PolygonTotal(
                    row.cell("table"),
                    row.cell("area"),
                    row.cell("schemas"),
                    Long.parseLong(row.cell("printed")),
                    Long.parseLong(row.cell("recomputed")),
                    row.cell("note")))
        .toList();
  }

  static List<ScoreRow> scores() {
    return rows("tables-6-11.csv")
        .map(
            row ->
                new ScoreRow(
                    row.cell("area"),
                    row.cell("objects").equals("all") ? "neutral" : row.cell("objects"),
                    Integer.parseInt(row.cell("O")),
                    row.cell("condition"),
                    LEVELS.stream()
                        .map(
                            level ->
                                new ScoreTarget(
                                    number(row, "d_" + level),
                                    number(row, "d_" + level + "_sd"),
                                    number(row, "b_" + level),
                                    number(row, "b_" + level + "_sd")))
                        .toList()))
        .toList();
  }

  static List<KitchenCell> kitchenMeans() {
    return rows("kitchen-means.csv")
        .map(
            row ->
                new KitchenCell(
                    row.cell("measure"),
                    row.cell("level"),
                    row.cell("group"),
                    number(row, "mean"),
                    number(row, "sd"),
                    Integer.parseInt(row.cell("n")),
                    number(row, "covariance")))
        .toList();
  }

  static List<KitchenFigure> kitchenFigures() {
    return rows("kitchen-results.csv")
        .flatMap(
            row ->
                Stream.of("ss", "ms", "F", "p", "pillai", "wilks", "hotelling", "roy")
                    .filter(statistic -> !row.cell(statistic).isEmpty())
                    .map(
                        statistic ->
                            new KitchenFigure(
                                row.cell("measure"),
                                row.cell("figure"),
                                row.cell("effect"),
                                statistic,
                                row.cell(statistic))))
        .toList();
  }

  static List<PrintedEffect> effects() {
    return rows("effects.csv")
        .map(
            row ->
                new PrintedEffect(
                    row.cell("area"),
                    level(row.cell("level")),
                    measure(row.cell("measure")),
                    row.cell("effect"),
                    number(row, "printed"),
                    Integer.parseInt(row.cell("df1")),
                    Integer.parseInt(row.cell("df2")),
                    row.cell("source")))
        .toList();
  }

  private static ConfidenceThreshold level(String spelling) {
    return Arrays.stream(ConfidenceThreshold.values())
        .filter(level -> level.spelling().equals(spelling))
        .findFirst()
        .orElseThrow();
  }

  private static DetectionMeasure measure(String key) {
    return Arrays.stream(DetectionMeasure.values())
        .filter(measure -> measure.key().equals(key))
        .findFirst()
        .orElseThrow();
  }

  private static double number(CsvRow row, String column) {
    return Double.parseDouble(row.cell(column));
  }

  private static Stream<CsvRow> rows(String resource) {
    try (InputStream in = ThesisTables.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalStateException("the program's table " + resource + " is missing");
      }
      return CsvTable.parse(
          resource,
          in.readAllBytes(),
          (at, fault) -> {
            throw new IllegalStateException(at + ": " + fault);
          })
          .orElseThrow()
          .rows()
          .stream();
    } catch (IOException e) {
      throw new UncheckedIOException("the program's table " + resource + " cannot be read", e);
    }
  }
}
