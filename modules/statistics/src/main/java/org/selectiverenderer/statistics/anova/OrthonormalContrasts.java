package org.selectiverenderer.statistics.anova;

import java.util.List;
import java.util.function.Predicate;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Matrices of orthonormal columns over the levels of a factor, or over the combinations of levels
 * of several: the average, and contrasts (Helmert contrasts of unit length; no test here depends on
 * which contrasts are chosen). Maxwell and Delaney 2004, Designing Experiments and Analyzing Data,
 * chapters 13 and 14.
 */
public final class OrthonormalContrasts {
  private OrthonormalContrasts() {}

  /**
   * Returns one column, the average. Its sums of squares are those that SPSS prints for "Average"
   * (thesis Fig 94).
   */
  static RealMatrix average(int levels) {
    return new Array2DRowRealMatrix(levels, 1).scalarAdd(1 / Math.sqrt(levels));
  }

  /** Returns levels - 1 columns, each orthogonal to the average and to the others. */
  static RealMatrix contrasts(int levels) {
    RealMatrix columns = new Array2DRowRealMatrix(levels, levels - 1);
    for (int column = 0; column < levels - 1; column++) {
      double length = Math.sqrt((column + 1.0) * (column + 2.0));
      for (int row = 0; row <= column; row++) {
        columns.setEntry(row, column, -1 / length);
      }
      columns.setEntry(column + 1, column, (column + 1) / length);
    }
    return columns;
  }

  /**
   * Returns orthonormal columns over the combinations of the factors' levels (the last factor's
   * level changes fastest): contrasts of some factors, averages of the others.
   *
   * @param compared whether the contrasts of a factor are taken instead of its average
   */
  public static RealMatrix of(List<Factor> factors, Predicate<Factor> compared) {
    RealMatrix all = MatrixUtils.createRealIdentityMatrix(1);
    for (Factor factor : factors) {
      int levels = factor.levels().size();
      all = product(all, compared.test(factor) ? contrasts(levels) : average(levels));
    }
    return all;
  }

  /** Returns the Kronecker product. */
  private static RealMatrix product(RealMatrix a, RealMatrix b) {
    int rows = b.getRowDimension();
    int columns = b.getColumnDimension();
    RealMatrix product =
        new Array2DRowRealMatrix(a.getRowDimension() * rows, a.getColumnDimension() * columns);
    for (int i = 0; i < a.getRowDimension(); i++) {
      for (int j = 0; j < a.getColumnDimension(); j++) {
        product.setSubMatrix(b.scalarMultiply(a.getEntry(i, j)).getData(), i * rows, j * columns);
      }
    }
    return product;
  }
}
