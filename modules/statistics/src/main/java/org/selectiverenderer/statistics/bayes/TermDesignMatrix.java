package org.selectiverenderer.statistics.bayes;

import org.apache.commons.math3.linear.RealMatrix;
import org.selectiverenderer.statistics.anova.Term;

/**
 * The design matrix of a term over the groups of one stratum.
 *
 * @param matrix dimensions of the space x degrees of freedom of the term among groups
 */
record TermDesignMatrix(Term term, RealMatrix matrix) {
  private static final double ORTHOGONAL = 1e-9;

  boolean orthogonalTo(TermDesignMatrix other) {
    RealMatrix products = matrix.transpose().multiply(other.matrix);
    return products.getFrobeniusNorm()
        <= ORTHOGONAL * matrix.getFrobeniusNorm() * other.matrix.getFrobeniusNorm();
  }

  /** Returns the mean squared length of the columns. */
  double size() {
    double norm = matrix.getFrobeniusNorm();
    return norm * norm / matrix.getColumnDimension();
  }
}
