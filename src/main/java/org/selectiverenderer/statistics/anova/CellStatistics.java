package org.selectiverenderer.statistics.anova;

import java.util.List;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;

/** Means and error of a design: all that its tests are made of. */
final class CellStatistics {
  private final int[] sizes;
  private final double[][] means;
  private final RealMatrix error;
  private final int errorDf;

  private CellStatistics(int[] sizes, double[][] means, RealMatrix error, int errorDf) {
    this.sizes = sizes;
    this.means = means;
    this.error = error;
    this.errorDf = errorDf;
  }

  static CellStatistics of(Design design) {
    int groups = design.between().levels().size();
    int levels = design.within().levels().size();
    int[] sizes = new int[groups];
    double[][] means = new double[groups][levels];
    double[][] error = new double[levels][levels];
    for (int group = 0; group < groups; group++) {
      List<Subject> subjects = design.group(group);
      sizes[group] = subjects.size();
      for (Subject subject : subjects) {
        for (int level = 0; level < levels; level++) {
          means[group][level] += subject.values().get(level) / sizes[group];
        }
      }
      for (Subject subject : subjects) {
        for (int a = 0; a < levels; a++) {
          for (int b = 0; b < levels; b++) {
            error[a][b] +=
                (subject.values().get(a) - means[group][a])
                    * (subject.values().get(b) - means[group][b]);
          }
        }
      }
    }
    return new CellStatistics(
        sizes, means, new Array2DRowRealMatrix(error, false), design.subjects().size() - groups);
  }

  int groups() {
    return sizes.length;
  }

  int levels() {
    return means[0].length;
  }

  int size(int group) {
    return sizes[group];
  }

  int subjects() {
    int sum = 0;
    for (int size : sizes) {
      sum += size;
    }
    return sum;
  }

  /** Means of a group at the levels of the within factor. */
  double[] means(int group) {
    return means[group].clone();
  }

  /** Sums of squares and products of the within levels around the group's means. */
  RealMatrix error() {
    return error;
  }

  /** Subjects less groups. */
  int errorDf() {
    return errorDf;
  }

  /** The pooled covariance of the within levels. */
  RealMatrix covariance() {
    return error.scalarMultiply(1.0 / errorDf);
  }

  /** Means with equal weight for each group, whatever its size: those of type III sums. */
  double[] unweightedMeans() {
    double[] mean = new double[levels()];
    for (double[] group : means) {
      for (int level = 0; level < mean.length; level++) {
        mean[level] += group[level] / means.length;
      }
    }
    return mean;
  }

  /** Means with equal weight for each subject. */
  double[] weightedMeans() {
    double[] mean = new double[levels()];
    for (int group = 0; group < groups(); group++) {
      for (int level = 0; level < mean.length; level++) {
        mean[level] += means[group][level] * sizes[group] / subjects();
      }
    }
    return mean;
  }

  /**
   * What the unweighted mean's variance is divided by: g times the harmonic mean of the group sizes
   * (Maxwell and Delaney 2004, 7.4), which is the number of subjects when balanced.
   */
  double effectiveSubjects() {
    double sum = 0;
    for (int size : sizes) {
      sum += 1.0 / size;
    }
    return groups() * groups() / sum;
  }
}
