package org.selectiverenderer.statistics.anova;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * What the model of a design leaves of its scores.
 *
 * @param values a row for each subject, a column for each combination of within levels
 * @param leverages of the subjects, 0 to 1: how much a score draws its own estimate
 * @param df of each column
 */
public record Residuals(double[][] values, double[] leverages, int df) {
  static Residuals of(CellStatistics cells) {
    return new Residuals(cells.residuals(), cells.leverages(), cells.errorDf());
  }

  /** The residuals at a combination of within levels, subject by subject. */
  public double[] column(int level) {
    return Arrays.stream(values).mapToDouble(row -> row[level]).toArray();
  }

  /**
   * A column in standard errors, each residual's from the other subjects: t with df - 1 degrees of
   * freedom (Belsley, Kuh and Welsch 1980, Regression Diagnostics); not a number for a subject
   * whose score alone decides its estimate.
   */
  public double[] studentised(int level) {
    double[] e = column(level);
    double sum = Arrays.stream(e).map(x -> x * x).sum();
    return IntStream.range(0, e.length)
        .mapToDouble(
            i -> {
              double own = 1 - leverages[i];
              double variance = (sum - e[i] * e[i] / own) / (df - 1);
              boolean defined = own > 1e-12 && df > 1 && variance > 1e-12 * sum / df;
              return defined ? e[i] / Math.sqrt(variance * own) : Double.NaN;
            })
        .toArray();
  }
}
