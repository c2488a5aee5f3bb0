package org.selectiverenderer.app.replication;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.simulation.ScoreTarget;

/**
 * What Tables 6 to 11 say about the tests that the thesis tells. F of conditions follows from their
 * means and standard deviations where objects are of one type; F of types needs the correlation of
 * the two scores, which the tables lack, so that F tells which one it implies.
 */
final class PrintedTests {
  /** The tables are cut off after two decimals, so that a number lies half a unit higher. */
  private static final double HALF = 0.005;

  private PrintedTests() {}

  /** Returns a sentence without its full stop; empty where the tables say nothing. */
  static String remark(ThesisTables.PrintedEffect test) {
    List<ThesisTables.ScoreRow> rows =
        ThesisTables.scores().stream()
            .filter(row -> !row.total() && row.area().equals(test.area()))
            .toList();
    if (test.effect().equals("type")) {
      OptionalDouble r = correlation(test, rows);
      return r.isEmpty()
          ? ""
          : String.format(
                  Locale.ROOT,
                  "implies a correlation of %.2f between the types%s",
                  r.getAsDouble(),
                  Math.abs(r.getAsDouble()) > 0.9
                      ? ", which scores of different objects do not have: F or the means are misprinted"
                      : "")
              .replace("of -0.00", "of 0.00")
              .replace("of -", "of \u2212");
    }
    return rows.stream().allMatch(row -> row.type().equals("neutral"))
        ? String.format(Locale.ROOT, "two-digit means and deviations give F = %.2f", f(test, rows))
        : "";
  }

  /** Returns the correlation with which the printed means and deviations have the printed F. */
  static OptionalDouble correlation(
      ThesisTables.PrintedEffect test, List<ThesisTables.ScoreRow> rows) {
    double[] means = new double[2];
    double[] variances = new double[2];
    List<String> types = List.of("consistent", "inconsistent");
    for (int type = 0; type < 2; type++) {
      String name = types.get(type);
      List<ThesisTables.ScoreRow> own =
          rows.stream().filter(row -> row.type().equals(name)).toList();
      if (own.isEmpty()) {
        return OptionalDouble.empty();
      }
      means[type] = own.stream().mapToDouble(row -> mean(row, test)).average().orElseThrow();
      variances[type] =
          own.stream().mapToDouble(row -> Math.pow(sd(row, test), 2)).average().orElseThrow();
    }
    double difference = means[1] - means[0];
    int participants = test.df2() + 3;
    double variance = participants * difference * difference / test.f();
    return OptionalDouble.of(
        (variances[0] + variances[1] - variance) / (2 * Math.sqrt(variances[0] * variances[1])));
  }

  /** Returns F of the conditions. */
  static double f(ThesisTables.PrintedEffect test, List<ThesisTables.ScoreRow> rows) {
    double grand = rows.stream().mapToDouble(row -> mean(row, test)).average().orElseThrow();
    double between =
        rows.stream().mapToDouble(row -> Math.pow(mean(row, test) - grand, 2)).sum()
            / (rows.size() - 1);
    double within =
        rows.stream().mapToDouble(row -> Math.pow(sd(row, test), 2)).average().orElseThrow();
    int each = (test.df2() + rows.size()) / rows.size();
    return each * between / within;
  }

  private static double mean(ThesisTables.ScoreRow row, ThesisTables.PrintedEffect test) {
    ScoreTarget level = level(row, test.level());
    double printed = test.measure() == DetectionMeasure.D_PRIME ? level.dPrime() : level.logBeta();
    return printed + Math.copySign(HALF, printed);
  }

  private static double sd(ThesisTables.ScoreRow row, ThesisTables.PrintedEffect test) {
    ScoreTarget level = level(row, test.level());
    return HALF
        + (test.measure() == DetectionMeasure.D_PRIME ? level.dPrimeSd() : level.logBetaSd());
  }

  private static ScoreTarget level(ThesisTables.ScoreRow row, ConfidenceThreshold level) {
    return row.levels().get(level.ordinal());
  }
}
