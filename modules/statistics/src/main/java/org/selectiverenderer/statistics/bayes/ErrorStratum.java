package org.selectiverenderer.statistics.bayes;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.selectiverenderer.statistics.anova.Factor;
import org.selectiverenderer.statistics.anova.FactorialDesign;
import org.selectiverenderer.statistics.anova.OrthonormalContrasts;
import org.selectiverenderer.statistics.anova.Subject;
import org.selectiverenderer.statistics.anova.Term;

/**
 * An error stratum of the design (as in R's aov): the data projected onto the average of the within
 * levels, or onto the contrasts of a set of within factors.
 *
 * @param average whether this is the stratum of the average, from which the grand mean is removed
 * @param components blocks of terms that are not orthogonal within a block; the spaces of the
 *     blocks are orthogonal
 * @param dimensions number of dimensions of the data
 * @param rest residual sum of squares, outside of the components' spaces
 */
record ErrorStratum(
    boolean average, List<NonorthogonalTermBlock> components, int dimensions, double rest) {
  ErrorStratum {
    components = List.copyOf(components);
  }

  /**
   * Returns the stratum of a set of within factors.
   *
   * @param within empty for the stratum of the average
   * @param terms the terms of the design with exactly these within factors
   */
  static ErrorStratum of(FactorialDesign design, List<Factor> within, List<Term> terms) {
    RealMatrix contrasts = OrthonormalContrasts.of(design.withinFactors(), within::contains);
    int groups = design.between().levels().size();
    int[] sizes = new int[groups];
    design.subjects().forEach(subject -> sizes[subject.group()]++);
    RealMatrix scores = scores(design, contrasts);
    RealMatrix means = new Array2DRowRealMatrix(groups, contrasts.getColumnDimension());
    RealMatrix roots = new Array2DRowRealMatrix(groups, groups);
    for (int i = 0; i < design.subjects().size(); i++) {
      int group = design.subjects().get(i).group();
      for (int column = 0; column < means.getColumnDimension(); column++) {
        means.addToEntry(group, column, scores.getEntry(i, column) / sizes[group]);
      }
    }
    double rest = 0;
    for (int i = 0; i < design.subjects().size(); i++) {
      for (int column = 0; column < means.getColumnDimension(); column++) {
        double mean = means.getEntry(design.subjects().get(i).group(), column);
        rest += Math.pow(scores.getEntry(i, column) - mean, 2);
      }
    }
    for (int group = 0; group < groups; group++) {
      roots.setEntry(group, group, Math.sqrt(sizes[group]));
    }
    RealMatrix space = MatrixUtils.createRealIdentityMatrix(groups);
    boolean average = within.isEmpty();
    if (average) {
      space = complement(roots);
    }
    int compared =
        within.stream().mapToInt(factor -> factor.levels().size()).reduce(1, Math::multiplyExact);
    double length = Math.sqrt((double) design.within().levels().size() / compared);
    List<TermDesignMatrix> columns = new ArrayList<>();
    for (Term term : terms) {
      RealMatrix coded = coding(design, term).scalarMultiply(length);
      columns.add(new TermDesignMatrix(term, space.multiply(roots).multiply(coded)));
    }
    RealMatrix data = space.multiply(roots).multiply(means);
    List<NonorthogonalTermBlock> components = new ArrayList<>();
    double outside = square(data);
    for (List<TermDesignMatrix> connected : connected(columns)) {
      NonorthogonalTermBlock component = NonorthogonalTermBlock.of(connected, data);
      components.add(component);
      outside -= component.sum();
    }
    int dimensions =
        (design.subjects().size() - (average ? 1 : 0)) * contrasts.getColumnDimension();
    return new ErrorStratum(average, components, dimensions, rest + Math.max(0, outside));
  }

  private static RealMatrix scores(FactorialDesign design, RealMatrix contrasts) {
    RealMatrix scores =
        new Array2DRowRealMatrix(design.subjects().size(), contrasts.getRowDimension());
    for (int i = 0; i < design.subjects().size(); i++) {
      Subject subject = design.subjects().get(i);
      scores.setRow(i, subject.values().stream().mapToDouble(Double::doubleValue).toArray());
    }
    return scores.multiply(contrasts);
  }

  /**
   * Returns the design matrix of a term over the groups: contrasts of its between factors, repeated
   * over the levels of the others.
   */
  private static RealMatrix coding(FactorialDesign design, Term term) {
    double repeats = 1;
    for (Factor factor : design.betweenFactors()) {
      if (!term.between().contains(factor)) {
        repeats *= factor.levels().size();
      }
    }
    return OrthonormalContrasts.of(design.betweenFactors(), term.between()::contains)
        .scalarMultiply(Math.sqrt(repeats));
  }

  /** Returns orthonormal rows that are orthogonal to the grand mean. */
  private static RealMatrix complement(RealMatrix roots) {
    int groups = roots.getRowDimension();
    RealMatrix mean = new Array2DRowRealMatrix(groups, 1).scalarAdd(1);
    RealMatrix q = new QRDecomposition(roots.multiply(mean)).getQ();
    if (groups == 1) {
      return new Array2DRowRealMatrix(1, 1);
    }
    return q.getSubMatrix(0, groups - 1, 1, groups - 1).transpose();
  }

  private static List<List<TermDesignMatrix>> connected(List<TermDesignMatrix> columns) {
    List<List<TermDesignMatrix>> found = new ArrayList<>();
    for (TermDesignMatrix column : columns) {
      List<TermDesignMatrix> own = new ArrayList<>();
      for (List<TermDesignMatrix> set : List.copyOf(found)) {
        if (!set.stream().allMatch(column::orthogonalTo)) {
          own.addAll(set);
          found.remove(set);
        }
      }
      own.add(column);
      found.add(own);
    }
    return found;
  }

  static double square(RealMatrix matrix) {
    double norm = matrix.getFrobeniusNorm();
    return norm * norm;
  }

  /** Returns the total sum of squares of the stratum, without the grand mean. */
  double sum() {
    return rest + components.stream().mapToDouble(NonorthogonalTermBlock::sum).sum();
  }
}
