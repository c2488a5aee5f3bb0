package org.selectiverenderer.statistics.anova;

import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * Sums of squares and products of an effect and of its error, in transformed within levels.
 *
 * <p>Type III (marginal) sums of a design with one between factor have closed forms. The common
 * mean is tested with equal weight for each group: H = m m' g² / sum(1/n_j), m the unweighted mean
 * of the group means. The groups are compared around the weighted mean, as no other between factor
 * has to be held constant (Maxwell and Delaney 2004, chapters 7 and 14; SPSS GLM, SSTYPE(3)).
 *
 * @param effect dimensions x dimensions
 * @param error dimensions x dimensions
 * @param effectDf 1, or groups - 1
 * @param errorDf subjects - groups
 */
record Hypothesis(RealMatrix effect, RealMatrix error, int effectDf, int errorDf) {
  static Hypothesis of(EffectKind kind, CellStatistics cells) {
    RealMatrix m =
        kind.ofContrasts()
            ? Transformation.contrasts(cells.levels())
            : Transformation.average(cells.levels());
    RealMatrix error = m.transpose().multiply(cells.error()).multiply(m);
    if (!kind.ofGroups()) {
      RealVector mean = m.preMultiply(MatrixUtils.createRealVector(cells.unweightedMeans()));
      RealMatrix effect = mean.outerProduct(mean).scalarMultiply(cells.effectiveSubjects());
      return new Hypothesis(effect, error, 1, cells.errorDf());
    }
    RealMatrix effect = error.scalarMultiply(0);
    RealVector centre = MatrixUtils.createRealVector(cells.weightedMeans());
    for (int group = 0; group < cells.groups(); group++) {
      RealVector mean = MatrixUtils.createRealVector(cells.means(group)).subtract(centre);
      RealVector distance = m.preMultiply(mean);
      effect = effect.add(distance.outerProduct(distance).scalarMultiply(cells.size(group)));
    }
    return new Hypothesis(effect, error, cells.groups() - 1, cells.errorDf());
  }

  /** 1 for the average, levels - 1 for the contrasts. */
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
