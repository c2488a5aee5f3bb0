package org.selectiverenderer.statistics.anova;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Orthonormal transformations of the within levels: their average, and the contrasts between them
 * (Helmert's, of unit length; which ones makes no difference to any test here). Maxwell and Delaney
 * 2004, Designing Experiments and Analyzing Data, chapters 13 and 14.
 */
final class Transformation {
  private Transformation() {}

  /** One column. Sums of squares of it are those that SPSS prints for "Average" (thesis Fig 94). */
  static RealMatrix average(int levels) {
    return new Array2DRowRealMatrix(levels, 1).scalarAdd(1 / Math.sqrt(levels));
  }

  /** levels - 1 columns, each orthogonal to the average and to the others. */
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
}
