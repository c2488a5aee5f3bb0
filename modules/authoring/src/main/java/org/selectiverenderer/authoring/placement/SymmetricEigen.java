package org.selectiverenderer.authoring.placement;

/**
 * The eigenvectors of a symmetric matrix of three rows, by Jacobi rotations (Golub and Van Loan
 * 2013, 8.5). A matrix that is diagonal keeps its axes in their order.
 */
final class SymmetricEigen {
  private static final int MOST_SWEEPS = 50;

  private final double[][] a;
  private final double[][] vectors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  /**
   * @param matrix rows of a symmetric matrix
   */
  SymmetricEigen(double[][] matrix) {
    a = new double[][] {matrix[0].clone(), matrix[1].clone(), matrix[2].clone()};
    double size = Math.abs(a[0][0]) + Math.abs(a[1][1]) + Math.abs(a[2][2]);
    for (int sweep = 0; sweep < MOST_SWEEPS && off() > 1e-13 * size; sweep++) {
      rotate(0, 1);
      rotate(0, 2);
      rotate(1, 2);
    }
  }

  private double off() {
    return Math.abs(a[0][1]) + Math.abs(a[0][2]) + Math.abs(a[1][2]);
  }

  private void rotate(int p, int q) {
    if (a[p][q] == 0) {
      return;
    }
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
    double cos = 1 / Math.sqrt(t * t + 1);
    double sin = t * cos;
    for (int k = 0; k < 3; k++) {
      double kp = a[k][p];
      double kq = a[k][q];
      a[k][p] = cos * kp - sin * kq;
      a[k][q] = sin * kp + cos * kq;
    }
    for (int k = 0; k < 3; k++) {
      double pk = a[p][k];
      double qk = a[q][k];
      a[p][k] = cos * pk - sin * qk;
      a[q][k] = sin * pk + cos * qk;
      double vp = vectors[k][p];
      double vq = vectors[k][q];
      vectors[k][p] = cos * vp - sin * vq;
      vectors[k][q] = sin * vp + cos * vq;
    }
  }

  double value(int i) {
    return a[i][i];
  }

  /** Returns a component of an eigenvector. */
  double vector(int i, int component) {
    return vectors[component][i];
  }
}
