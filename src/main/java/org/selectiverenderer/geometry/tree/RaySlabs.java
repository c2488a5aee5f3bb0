package org.selectiverenderer.geometry.tree;

import org.joml.Vector3dc;

/** A ray prepared for slab tests against many axis-aligned boxes (Kay and Kajiya 1986). */
final class RaySlabs {
  /** Enlarges the exit parameter by the rounding error of its two operations (Ize 2013). */
  private static final double SLACK = 1 + 4 * Math.ulp(1.0);

  private final double[] origin;
  private final double[] inverse;

  RaySlabs(Vector3dc origin, Vector3dc direction) {
    this.origin = new double[] {origin.x(), origin.y(), origin.z()};
    this.inverse = new double[] {1 / direction.x(), 1 / direction.y(), 1 / direction.z()};
  }

  /**
   * Returns the ray parameter at which the ray enters a box, in lengths of its direction, at least
   * 0; NaN if it misses the box or enters it beyond {@code limit}, so that comparisons are false.
   */
  double enter(float[] boxes, int box, double limit) {
    double from = 0;
    double to = limit;
    int at = 6 * box;
    for (int axis = 0; axis < 3; axis++) {
      double low = boxes[at + axis] - origin[axis];
      double high = boxes[at + axis + 3] - origin[axis];
      if (low > high) {
        return Double.NaN;
      }
      if (Double.isInfinite(inverse[axis])) {
        // parallel to the slab: entirely inside or entirely outside
        if (low > 0 || high < 0) {
          return Double.NaN;
        }
        continue;
      }
      double a = low * inverse[axis];
      double b = high * inverse[axis];
      from = Math.max(from, Math.min(a, b));
      to = Math.min(to, Math.max(a, b) * SLACK);
    }
    return from <= to ? from : Double.NaN;
  }
}
