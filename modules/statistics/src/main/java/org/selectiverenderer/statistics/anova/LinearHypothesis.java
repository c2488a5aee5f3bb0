package org.selectiverenderer.statistics.anova;

import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * The hypothesis that an effect is absent, with the matrices of sums of squares and cross products
 * (SSCP) of the effect and of its error.
 *
 * <p>The effect is the hypothesis L B M = 0 about the model's coefficients: the rows of L compare
 * groups, or take their mean with equal weights, or pick a covariate's slope; the columns of M
 * compare or average within levels. The SSCP matrix of the effect is (L B M)' (L (X'X)^-1 L')^-1 (L
 * B M), which is of type III where every combination of levels has a subject (Searle 1987, Linear
 * Models for Unbalanced Data, chapter 9; Maxwell and Delaney 2004, chapters 7 and 14; SPSS GLM,
 * SSTYPE(3)).
 *
 * @param effect SSCP matrix H of the effect, dimensions x dimensions
 * @param error SSCP matrix E of the error, dimensions x dimensions
 * @param effectDf number of rows of L
 * @param errorDf subjects - groups - covariates
 */
record LinearHypothesis(RealMatrix effect, RealMatrix error, int effectDf, int errorDf) {
  static LinearHypothesis of(Term term, FactorialDesign design, MultivariateLinearModel cells) {
    RealMatrix m = OrthonormalContrasts.of(design.withinFactors(), term.within()::contains);
    RealMatrix l = rows(term, design, cells);
    RealMatrix estimate = l.multiply(cells.coefficients()).multiply(m);
    RealMatrix spread = l.multiply(cells.inverse()).multiply(l.transpose());
    RealMatrix effect =
        estimate.transpose().multiply(MatrixUtils.inverse(spread)).multiply(estimate);
    RealMatrix error = m.transpose().multiply(cells.error()).multiply(m);
    return new LinearHypothesis(effect, error, l.getRowDimension(), cells.errorDf());
  }

  private static RealMatrix rows(Term term, FactorialDesign design, MultivariateLinearModel cells) {
    int columns = cells.groups() + design.covariates().size();
    if (term.covariate().isPresent()) {
      RealMatrix slope = MatrixUtils.createRealMatrix(1, columns);
      int index = design.covariates().indexOf(term.covariate().get());
      slope.setEntry(0, cells.groups() + index, 1);
      return slope;
    }
    RealMatrix groups =
        OrthonormalContrasts.of(design.betweenFactors(), term.between()::contains).transpose();
    RealMatrix rows = MatrixUtils.createRealMatrix(groups.getRowDimension(), columns);
    rows.setSubMatrix(groups.getData(), 0, 0);
    return rows;
  }

  /** Returns the number of columns of M: 1 for the average, else the number of contrasts. */
  int dimensions() {
    return effect.getColumnDimension();
  }

  double sum() {
    return effect.getTrace();
  }

  double errorSum() {
    return error.getTrace();
  }

  double df1() {
    return (double) effectDf * dimensions();
  }

  double df2() {
    return (double) errorDf * dimensions();
  }
}
