package org.selectiverenderer.runtime.render.occlude;

/**
 * How near something comes to the eye at most, from cell to cell, as 1 / depth. What stands beside
 * a wall that is seen aslant is nearer in one cell than the wall is in another: so of a box not
 * only its nearest corner counts, but the faces that the eye sees, behind which all of it lies.
 */
final class NearSide {
  private static final int MOST_FACES = 3;

  private final double[] a = new double[MOST_FACES];
  private final double[] b = new double[MOST_FACES];
  private final double[] c = new double[MOST_FACES];
  private int faces;
  private double nearest;

  /** Begins with something that comes as near as that everywhere. */
  void begin(double everywhere) {
    nearest = everywhere;
    faces = 0;
  }

  /**
   * Adds a plane behind which it lies: 1 / depth = x * byX + y * byY + atOrigin, in cells.
   *
   * @param marginX by which what is drawn may stand beside where it is, in cells
   * @param marginY the same up and down
   */
  void face(double byX, double byY, double atOrigin, double marginX, double marginY) {
    a[faces] = byX;
    b[faces] = byY;
    c[faces++] = atOrigin + Math.abs(byX) * marginX + Math.abs(byY) * marginY;
  }

  /** The most anywhere. */
  double nearest() {
    return nearest;
  }

  /** Whether it is anywhere nearer in some cells than in others. */
  boolean slopes() {
    return faces > 0;
  }

  /** The most in a square around a point, in cells. */
  double nearest(double x, double y, double half) {
    double least = nearest;
    for (int i = 0; i < faces; i++) {
      double most = c[i] + a[i] * x + b[i] * y + (Math.abs(a[i]) + Math.abs(b[i])) * half;
      least = Math.min(least, most);
    }
    return least;
  }
}
