package org.selectiverenderer.render.occlusion;

/**
 * An upper bound, per cell, of how near an object comes to the eye, as 1 / depth. An object along a
 * wall that is seen at a grazing angle may be nearer in one cell than the wall is in another.
 * Therefore not only the nearest corner of its bounding box counts, but also the planes of the
 * faces that the eye sees, behind which all of the box lies.
 */
final class ConservativeDepthBound {
  private static final int MOST_FACES = 3;

  private final double[] a = new double[MOST_FACES];
  private final double[] b = new double[MOST_FACES];
  private final double[] c = new double[MOST_FACES];
  private int faces;
  private double nearest;

  /** Begins with a bound that holds everywhere. */
  void begin(double everywhere) {
    nearest = everywhere;
    faces = 0;
  }

  /**
   * Adds a plane behind which the object lies: 1 / depth = x * byX + y * byY + atOrigin, in cells.
   *
   * @param marginX the horizontal rasterisation error, in cells
   * @param marginY the vertical rasterisation error, in cells
   */
  void face(double byX, double byY, double atOrigin, double marginX, double marginY) {
    a[faces] = byX;
    b[faces] = byY;
    c[faces++] = atOrigin + Math.abs(byX) * marginX + Math.abs(byY) * marginY;
  }

  /** Returns the bound that holds everywhere. */
  double nearest() {
    return nearest;
  }

  /** Returns whether the bound differs between cells. */
  boolean slopes() {
    return faces > 0;
  }

  /** Returns the bound in a square around a point, in cells. */
  double nearest(double x, double y, double half) {
    double least = nearest;
    for (int i = 0; i < faces; i++) {
      double most = c[i] + a[i] * x + b[i] * y + (Math.abs(a[i]) + Math.abs(b[i])) * half;
      least = Math.min(least, most);
    }
    return least;
  }
}
