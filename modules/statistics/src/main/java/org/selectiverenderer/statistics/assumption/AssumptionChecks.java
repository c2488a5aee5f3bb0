package org.selectiverenderer.statistics.assumption;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.Residuals;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.distribution.TailProbabilities;

/**
 * The checks of the assumptions of an analysis of variance; all but Box's M and Welch's F use the
 * residuals of its model at each within level.
 *
 * @param levene Levene's tests, for designs with groups
 * @param box Box's M, for designs with groups and within levels if each group has enough
 *     participants
 * @param shapiro Shapiro-Wilk test of each within level, if there are 3 to 5000 participants
 * @param outliers scores whose Bonferroni-corrected p is below the significance level
 * @param welch Welch's F of the groups' averages, for designs with groups and without covariates
 * @param consequences what the results imply for the analysis, as sentences
 */
public record AssumptionChecks(
    List<LeveneTest> levene,
    Optional<BoxMTest> box,
    List<ShapiroWilkTest> shapiro,
    List<Outlier> outliers,
    Optional<WelchAnova> welch,
    List<String> consequences) {
  /** Makes defensive copies, so that the record is immutable. */
  public AssumptionChecks {
    levene = List.copyOf(levene);
    shapiro = List.copyOf(shapiro);
    outliers = List.copyOf(outliers);
    consequences = List.copyOf(consequences);
  }

  /** Checks the assumptions of an analysis. */
  public static AssumptionChecks of(Anova anova) {
    FactorialDesign design = anova.design();
    Residuals residuals = anova.residuals();
    boolean groups = design.between().varies();
    boolean repeated = design.within().varies();
    List<LeveneTest> levene = new ArrayList<>();
    List<ShapiroWilkTest> shapiro = new ArrayList<>();
    List<Outlier> outliers = new ArrayList<>();
    for (int level = 0; level < design.within().levels().size(); level++) {
      Optional<String> at =
          repeated ? Optional.of(design.within().levels().get(level)) : Optional.empty();
      double[] column = residuals.column(level);
      if (groups) {
        levene.add(LeveneTest.of(at, byGroup(design, column)));
      }
      if (varies(anova, level, column)) {
        ShapiroWilkTest.of(at, column).ifPresent(shapiro::add);
        outliers.addAll(outliers(anova, residuals, level, at));
      }
    }
    AssumptionChecks found =
        new AssumptionChecks(
            levene,
            groups && repeated ? BoxMTest.of(matrices(design, residuals)) : Optional.empty(),
            shapiro,
            outliers,
            groups && design.covariates().isEmpty()
                ? Optional.of(WelchAnova.of(byGroup(design, averages(design))))
                : Optional.empty(),
            List.of());
    return new AssumptionChecks(
        found.levene,
        found.box,
        found.shapiro,
        found.outliers,
        found.welch,
        AssumptionAdvice.of(anova, found));
  }

  /** Returns whether residuals exceed rounding error. */
  private static boolean varies(Anova anova, int level, double[] residuals) {
    double size = 0;
    for (Subject subject : anova.design().subjects()) {
      size = Math.max(size, Math.abs(subject.values().get(level)));
    }
    double largest = Arrays.stream(residuals).map(Math::abs).max().orElse(0);
    return largest > 1e-12 * size;
  }

  private static List<Outlier> outliers(
      Anova anova, Residuals residuals, int level, Optional<String> at) {
    List<Outlier> outliers = new ArrayList<>();
    double[] studentised = residuals.studentised(level);
    for (int i = 0; i < studentised.length; i++) {
      if (Double.isFinite(studentised[i])) {
        double p =
            Math.min(
                1,
                studentised.length
                    * TailProbabilities.tTwoSided(studentised[i], residuals.df() - 1.0));
        if (p < anova.options().alpha()) {
          Subject subject = anova.design().subjects().get(i);
          outliers.add(
              new Outlier(subject.id(), at, subject.values().get(level), studentised[i], p));
        }
      }
    }
    return outliers;
  }

  private static List<double[]> byGroup(FactorialDesign design, double[] values) {
    return IntStream.range(0, design.between().levels().size())
        .mapToObj(
            group ->
                IntStream.range(0, values.length)
                    .filter(i -> design.subjects().get(i).group() == group)
                    .mapToDouble(i -> values[i])
                    .toArray())
        .toList();
  }

  private static List<double[][]> matrices(FactorialDesign design, Residuals residuals) {
    return IntStream.range(0, design.between().levels().size())
        .mapToObj(
            group ->
                IntStream.range(0, residuals.values().length)
                    .filter(i -> design.subjects().get(i).group() == group)
                    .mapToObj(i -> residuals.values()[i])
                    .toArray(double[][]::new))
        .toList();
  }

  private static double[] averages(FactorialDesign design) {
    return design.subjects().stream()
        .mapToDouble(
            subject ->
                subject.values().stream().mapToDouble(Double::doubleValue).average().orElseThrow())
        .toArray();
  }

  /**
   * Welch's one-way analysis of variance, which does not assume equal variances (Welch 1951,
   * Biometrika 38).
   *
   * @param df2 degrees of freedom of the error by Welch's approximation, not a whole number
   */
  public record WelchAnova(double f, double df1, double df2, double p) {
    /** Runs the test; F and p are NaN where a group has one value or no variance. */
    static WelchAnova of(List<double[]> groups) {
      double k = groups.size();
      double weights = 0;
      double centre = 0;
      for (double[] group : groups) {
        double weight = group.length / StatUtils.variance(group);
        weights += weight;
        centre += weight * StatUtils.mean(group);
      }
      centre /= weights;
      double between = 0;
      double lack = 0;
      for (double[] group : groups) {
        double weight = group.length / StatUtils.variance(group);
        between += weight * Math.pow(StatUtils.mean(group) - centre, 2);
        lack += Math.pow(1 - weight / weights, 2) / (group.length - 1);
      }
      double f = between / (k - 1) / (1 + 2 * (k - 2) / (k * k - 1) * lack);
      double df2 = (k * k - 1) / (3 * lack);
      return Double.isFinite(f) && Double.isFinite(df2)
          ? new WelchAnova(f, k - 1, df2, TailProbabilities.f(f, k - 1, df2))
          : new WelchAnova(Double.NaN, k - 1, Double.NaN, Double.NaN);
    }
  }
}
