package org.selectiverenderer.authoring.geometry;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Finds how near points must be to count as equal: a small share of the size of what the faces
 * show, but less than half of their shortest edge, so that no face loses a side.
 */
final class WeldingTolerance {
  /** The tolerance as a share of the diagonal of the points that faces use. */
  private static final double SHARE = 1e-6;

  /** Two ends of an edge that are both this near to a third point stay apart. */
  private static final double OF_EDGE = 1.0 / 3;

  private WeldingTolerance() {}

  /**
   * Returns the largest distance of points that are equal.
   *
   * @param indices of points; those without a point are left out
   * @param faces start and end of each face in the indices
   */
  static double of(float[] points, int[] indices, List<int[]> faces) {
    double[] b = BoundingBox.EMPTY.toArray();
    double shortest = Double.POSITIVE_INFINITY;
    for (int[] face : faces) {
      int before = face[1] - 1;
      for (int i = face[0]; i < face[1]; before = i++) {
        if (!known(points, indices[i])) {
          continue;
        }
        for (int k = 0; k < 3; k++) {
          float at = points[3 * indices[i] + k];
          b[k] = Math.min(b[k], at);
          b[3 + k] = Math.max(b[3 + k], at);
        }
        if (known(points, indices[before])) {
          double edge = distance(points, indices[before], indices[i]);
          shortest = edge > 0 ? Math.min(shortest, edge) : shortest;
        }
      }
    }
    BoundingBox box = BoundingBox.of(b);
    return box.isEmpty() ? 0 : Math.min(SHARE * box.min().distance(box.max()), OF_EDGE * shortest);
  }

  private static boolean known(float[] points, int index) {
    return index >= 0 && 3L * index + 2 < points.length;
  }

  /** Returns a tolerance with four digits that count: {@code 0.000001414}, {@code 3.2E-9}. */
  static String text(double tolerance) {
    BigDecimal rounded = new BigDecimal(tolerance).round(new MathContext(4)).stripTrailingZeros();
    return rounded.scale() < 0 ? rounded.toPlainString() : rounded.toString();
  }

  /** Returns the distance of two points. */
  static double distance(float[] p, int one, int other) {
    double dx = (double) p[3 * one] - p[3 * other];
    double dy = (double) p[3 * one + 1] - p[3 * other + 1];
    double dz = (double) p[3 * one + 2] - p[3 * other + 2];
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
}
