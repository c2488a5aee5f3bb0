package org.selectiverenderer.statistics.assumption;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.selectiverenderer.statistics.anova.Anova;
import org.selectiverenderer.statistics.anova.Design;
import org.selectiverenderer.statistics.anova.Residuals;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.distribution.Tails;

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
public record Assumptions(
    List<Levene> levene,
    Optional<BoxM> box,
    List<ShapiroWilk> shapiro,
    List<Outlier> outliers,
    Optional<Welch> welch,
    List<String> consequences) {
  /** Makes defensive copies, so that the record is immutable. */
  public Assumptions {
    levene = List.copyOf(levene);
    shapiro = List.copyOf(shapiro);
    outliers = List.copyOf(outliers);
    consequences = List.copyOf(consequences);
  }

  /** Checks the assumptions of an analysis. */
  public static Assumptions of(Anova anova) {
    Design design = anova.design();
    Residuals residuals = anova.residuals();
    boolean groups = design.between().varies();
    boolean repeated = design.within().varies();
    List<Levene> levene = new ArrayList<>();
    List<ShapiroWilk> shapiro = new ArrayList<>();
    List<Outlier> outliers = new ArrayList<>();
    for (int level = 0; level < design.within().levels().size(); level++) {
      Optional<String> at =
          repeated ? Optional.of(design.within().levels().get(level)) : Optional.empty();
      double[] column = residuals.column(level);
      if (groups) {
        levene.add(Levene.of(at, byGroup(design, column)));
      }
      if (varies(anova, level, column)) {
        ShapiroWilk.of(at, column).ifPresent(shapiro::add);
        outliers.addAll(outliers(anova, residuals, level, at));
      }
    }
    Assumptions found =
        new Assumptions(
            levene,
            groups && repeated ? BoxM.of(matrices(design, residuals)) : Optional.empty(),
            shapiro,
            outliers,
            groups && design.covariates().isEmpty()
                ? Optional.of(Welch.of(byGroup(design, averages(design))))
                : Optional.empty(),
            List.of());
    return new Assumptions(
        found.levene,
        found.box,
        found.shapiro,
        found.outliers,
        found.welch,
        Consequences.of(anova, found));
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
            Math.min(1, studentised.length * Tails.tTwoSided(studentised[i], residuals.df() - 1.0));
        if (p < anova.options().alpha()) {
          Subject subject = anova.design().subjects().get(i);
          outliers.add(
              new Outlier(subject.id(), at, subject.values().get(level), studentised[i], p));
        }
      }
    }
    return outliers;
  }

  private static List<double[]> byGroup(Design design, double[] values) {
    return IntStream.range(0, design.between().levels().size())
        .mapToObj(
            group ->
                IntStream.range(0, values.length)
                    .filter(i -> design.subjects().get(i).group() == group)
                    .mapToDouble(i -> values[i])
                    .toArray())
        .toList();
  }

  private static List<double[][]> matrices(Design design, Residuals residuals) {
    return IntStream.range(0, design.between().levels().size())
        .mapToObj(
            group ->
                IntStream.range(0, residuals.values().length)
                    .filter(i -> design.subjects().get(i).group() == group)
                    .mapToObj(i -> residuals.values()[i])
                    .toArray(double[][]::new))
        .toList();
  }

  private static double[] averages(Design design) {
    return design.subjects().stream()
        .mapToDouble(
            subject ->
                subject.values().stream().mapToDouble(Double::doubleValue).average().orElseThrow())
        .toArray();
  }
}
