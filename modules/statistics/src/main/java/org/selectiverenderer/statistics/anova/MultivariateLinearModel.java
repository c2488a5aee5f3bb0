package org.selectiverenderer.statistics.anova;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * The multivariate linear model Y = X B + E of a design, from which all its tests are computed. Y
 * has a row for each subject and a column for each combination of within levels. X holds an
 * indicator of each group and the covariates, centred at their means over all subjects; B holds the
 * groups' means at those means of the covariates (without covariates the plain means), and the
 * slopes of the covariates.
 */
final class MultivariateLinearModel {
  /**
   * A covariate is redundant if the groups and the other covariates leave less than this share of
   * its sum of squares unexplained.
   */
  private static final double REDUNDANT = 1e-10;

  private final int[] sizes;
  private final RealMatrix coefficients;
  private final RealMatrix inverse;
  private final RealMatrix residuals;
  private final double[] leverages;

  private MultivariateLinearModel(
      int[] sizes,
      RealMatrix coefficients,
      RealMatrix inverse,
      RealMatrix residuals,
      double[] leverages) {
    this.sizes = sizes;
    this.coefficients = coefficients;
    this.inverse = inverse;
    this.residuals = residuals;
    this.leverages = leverages;
  }

  static MultivariateLinearModel of(FactorialDesign design) {
    int[] sizes = sizes(design);
    double[][] y = scores(design);
    double[][] means = groupMeans(design, sizes, y);
    RealMatrix inverse = MatrixUtils.createRealMatrix(sizes.length, sizes.length);
    for (int group = 0; group < sizes.length; group++) {
      inverse.setEntry(group, group, 1.0 / sizes[group]);
    }
    MultivariateLinearModel cells =
        new MultivariateLinearModel(
            sizes,
            MatrixUtils.createRealMatrix(means),
            inverse,
            MatrixUtils.createRealMatrix(inside(design, y, means)),
            design.subjects().stream()
                .mapToDouble(subject -> 1.0 / sizes[subject.group()])
                .toArray());
    return design.covariates().isEmpty() ? cells : cells.adjusted(design);
  }

  /**
   * Returns the model adjusted for the covariates: slopes are estimated from the deviations within
   * groups, and group means are taken at the covariates' means.
   */
  private MultivariateLinearModel adjusted(FactorialDesign design) {
    int groups = sizes.length;
    double[][] x = covariates(design);
    double[][] xMeans = groupMeans(design, sizes, x);
    RealMatrix own = MatrixUtils.createRealMatrix(inside(design, x, xMeans));
    RealMatrix centres = MatrixUtils.createRealMatrix(xMeans);
    RealMatrix spread = MatrixUtils.inverse(own.transpose().multiply(own));
    RealMatrix slopes = spread.multiply(own.transpose()).multiply(residuals);
    RealMatrix cross = centres.multiply(spread).scalarMultiply(-1);
    int size = groups + own.getColumnDimension();
    RealMatrix all = MatrixUtils.createRealMatrix(size, size);
    all.setSubMatrix(
        inverse.add(centres.multiply(spread).multiply(centres.transpose())).getData(), 0, 0);
    all.setSubMatrix(cross.getData(), 0, groups);
    all.setSubMatrix(cross.transpose().getData(), groups, 0);
    all.setSubMatrix(spread.getData(), groups, groups);
    RealMatrix both = MatrixUtils.createRealMatrix(size, levels());
    both.setSubMatrix(coefficients.subtract(centres.multiply(slopes)).getData(), 0, 0);
    both.setSubMatrix(slopes.getData(), groups, 0);
    double[] drawn = leverages.clone();
    for (int i = 0; i < drawn.length; i++) {
      RealVector row = own.getRowVector(i);
      drawn[i] += row.dotProduct(spread.operate(row));
    }
    return new MultivariateLinearModel(
        sizes, both, all, residuals.subtract(own.multiply(slopes)), drawn);
  }

  private static int[] sizes(FactorialDesign design) {
    int[] sizes = new int[design.between().levels().size()];
    design.subjects().forEach(subject -> sizes[subject.group()]++);
    return sizes;
  }

  private static double[][] scores(FactorialDesign design) {
    return design.subjects().stream()
        .map(subject -> array(subject.values()))
        .toArray(double[][]::new);
  }

  /**
   * Returns the first covariate that is constant within all groups, or a linear combination of the
   * covariates before it.
   */
  static Optional<String> redundantCovariate(FactorialDesign design) {
    if (design.covariates().isEmpty()) {
      return Optional.empty();
    }
    double[][] x = covariates(design);
    RealMatrix inside =
        MatrixUtils.createRealMatrix(inside(design, x, groupMeans(design, sizes(design), x)));
    RealMatrix raw = MatrixUtils.createRealMatrix(x);
    for (int column = 0; column < design.covariates().size(); column++) {
      RealMatrix first = inside.getSubMatrix(0, x.length - 1, 0, column);
      RealMatrix products = first.transpose().multiply(first);
      double left =
          column == 0
              ? products.getEntry(0, 0)
              : new LUDecomposition(products, 0).getDeterminant()
                  / new LUDecomposition(products.getSubMatrix(0, column - 1, 0, column - 1), 0)
                      .getDeterminant();
      double whole = raw.getColumnVector(column).dotProduct(raw.getColumnVector(column));
      if (!(left > REDUNDANT * whole)) {
        return Optional.of(design.covariates().get(column));
      }
    }
    return Optional.empty();
  }

  /** Returns a row for each subject: the covariates, centred at their means over all subjects. */
  private static double[][] covariates(FactorialDesign design) {
    double[][] x =
        design.subjects().stream()
            .map(subject -> array(subject.covariates()))
            .toArray(double[][]::new);
    for (int column = 0; column < design.covariates().size(); column++) {
      double mean = 0;
      for (double[] row : x) {
        mean += row[column] / x.length;
      }
      for (double[] row : x) {
        row[column] -= mean;
      }
    }
    return x;
  }

  private static double[][] groupMeans(FactorialDesign design, int[] sizes, double[][] rows) {
    double[][] means = new double[sizes.length][rows[0].length];
    for (int i = 0; i < rows.length; i++) {
      int group = design.subjects().get(i).group();
      for (int column = 0; column < rows[i].length; column++) {
        means[group][column] += rows[i][column] / sizes[group];
      }
    }
    return means;
  }

  /** Returns the deviations from the groups' means. */
  private static double[][] inside(FactorialDesign design, double[][] rows, double[][] means) {
    List<double[]> inside = new ArrayList<>();
    for (int i = 0; i < rows.length; i++) {
      double[] row = rows[i].clone();
      double[] mean = means[design.subjects().get(i).group()];
      for (int column = 0; column < row.length; column++) {
        row[column] -= mean[column];
      }
      inside.add(row);
    }
    return inside.toArray(double[][]::new);
  }

  private static double[] array(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).toArray();
  }

  int groups() {
    return sizes.length;
  }

  int levels() {
    return coefficients.getColumnDimension();
  }

  int size(int group) {
    return sizes[group];
  }

  int subjects() {
    return Arrays.stream(sizes).sum();
  }

  /**
   * Returns the means of a group at each combination of within levels, at the means of the
   * covariates.
   */
  double[] means(int group) {
    return coefficients.getRow(group);
  }

  /** Returns B: the groups' means, then the covariates' slopes. */
  RealMatrix coefficients() {
    return coefficients;
  }

  /** Returns (X'X)^-1; without covariates, this is diagonal with 1 / n of each group. */
  RealMatrix inverse() {
    return inverse;
  }

  /** Returns the sums of squares and cross products (SSCP) of the residuals. */
  RealMatrix error() {
    return residuals.transpose().multiply(residuals);
  }

  /** Returns the residuals, a row for each subject. */
  double[][] residuals() {
    return residuals.getData();
  }

  /** Returns the leverage of each subject. */
  double[] leverages() {
    return leverages.clone();
  }

  /** Returns the number of subjects less that of groups and covariates. */
  int errorDf() {
    return subjects() - coefficients.getRowDimension();
  }

  /** Returns the pooled covariance matrix of the within levels. */
  RealMatrix covariance() {
    return error().scalarMultiply(1.0 / errorDf());
  }
}
