package org.selectiverenderer.statistics.anova;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The residuals of the linear model of a design.
 *
 * @param values a row for each subject, a column for each combination of within levels
 * @param leverages leverages of the subjects, 0 to 1: how strongly a score influences its own
 *     fitted value
 * @param df degrees of freedom of each column
 */
public record Residuals(double[][] values, double[] leverages, int df) {
  static Residuals of(MultivariateLinearModel cells) {
    return new Residuals(cells.residuals(), cells.leverages(), cells.errorDf());
  }

  /** Returns the residuals at a combination of within levels, subject by subject. */
  public double[] column(int level) {
    return Arrays.stream(values).mapToDouble(row -> row[level]).toArray();
  }

  /**
   * Returns the externally studentised residuals of a column: each is divided by its standard error
   * as estimated from the other subjects, and is distributed as t with df - 1 degrees of freedom
   * (Belsley, Kuh and Welsch 1980, Regression Diagnostics); NaN for a subject whose score alone
   * determines its fitted value.
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
