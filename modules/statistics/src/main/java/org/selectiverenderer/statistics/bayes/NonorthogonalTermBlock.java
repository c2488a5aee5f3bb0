package org.selectiverenderer.statistics.bayes;

import java.util.List;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * A block of terms whose design matrices are not orthogonal to each other, with the data projected
 * onto the space that they span.
 *
 * @param columns design matrices of the terms, in coordinates of the spanned space
 * @param data the projected data: dimensions of the space x contrasts
 */
record NonorthogonalTermBlock(List<TermDesignMatrix> columns, RealMatrix data) {
  private static final double RANK = 1e-9;

  NonorthogonalTermBlock {
    columns = List.copyOf(columns);
  }

  static NonorthogonalTermBlock of(List<TermDesignMatrix> columns, RealMatrix data) {
    RealMatrix all = columns.get(0).matrix();
    for (TermDesignMatrix column : columns.subList(1, columns.size())) {
      RealMatrix wider =
          MatrixUtils.createRealMatrix(
              all.getRowDimension(),
              all.getColumnDimension() + column.matrix().getColumnDimension());
      wider.setSubMatrix(all.getData(), 0, 0);
      wider.setSubMatrix(column.matrix().getData(), 0, all.getColumnDimension());
      all = wider;
    }
    SingularValueDecomposition found = new SingularValueDecomposition(all);
    int rank = 0;
    for (double value : found.getSingularValues()) {
      rank += value > RANK * found.getNorm() ? 1 : 0;
    }
    RealMatrix space =
        found.getU().getSubMatrix(0, all.getRowDimension() - 1, 0, rank - 1).transpose();
    return new NonorthogonalTermBlock(
        columns.stream()
            .map(column -> new TermDesignMatrix(column.term(), space.multiply(column.matrix())))
            .toList(),
        space.multiply(data));
  }

  /** Returns the sum of squares of the projected data. */
  double sum() {
    return ErrorStratum.square(data);
  }

  /** Returns the number of contrasts. */
  int width() {
    return data.getColumnDimension();
  }

  /**
   * Returns the two parts of the deviance at given g: the log-determinant of V = I + sum of g_t A_t
   * A_t', and the generalised sum of squares trace(Y' V^-1 Y) of the data.
   */
  double[] at(List<TermDesignMatrix> terms, double[] logG) {
    RealMatrix v = MatrixUtils.createRealIdentityMatrix(data.getRowDimension());
    for (int t = 0; t < terms.size(); t++) {
      RealMatrix a = terms.get(t).matrix();
      v = v.add(a.multiply(a.transpose()).scalarMultiply(Math.exp(logG[t])));
    }
    CholeskyDecomposition root = new CholeskyDecomposition(v, 1e-6, 0);
    double determinant = 0;
    for (int i = 0; i < v.getRowDimension(); i++) {
      determinant += 2 * Math.log(root.getL().getEntry(i, i));
    }
    RealMatrix solved = root.getSolver().solve(data);
    return new double[] {determinant, data.transpose().multiply(solved).getTrace()};
  }
}
