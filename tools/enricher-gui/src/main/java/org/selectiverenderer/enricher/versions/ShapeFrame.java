package org.selectiverenderer.enricher.versions;

/**
 * The sphere that a shape is in.
 *
 * @param radius above 0
 */
record ShapeFrame(double x, double y, double z, double radius) {
  /** Around the box of some points. */
  static ShapeFrame around(float[] points) {
    double[] least = {0, 0, 0};
    double[] most = {0, 0, 0};
    for (int i = 0; i < points.length; i++) {
      int axis = i % 3;
      least[axis] = i < 3 ? points[i] : Math.min(least[axis], points[i]);
      most[axis] = i < 3 ? points[i] : Math.max(most[axis], points[i]);
    }
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      square += (most[axis] - least[axis]) * (most[axis] - least[axis]);
    }
    return new ShapeFrame(
        (least[0] + most[0]) / 2,
        (least[1] + most[1]) / 2,
        (least[2] + most[2]) / 2,
        Math.max(Math.sqrt(square) / 2, 1e-9));
  }
}
