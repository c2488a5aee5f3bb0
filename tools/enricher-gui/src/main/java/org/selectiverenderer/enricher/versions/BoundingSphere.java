package org.selectiverenderer.enricher.versions;

/**
 * A bounding sphere.
 *
 * @param radius the radius, above 0
 */
record BoundingSphere(double x, double y, double z, double radius) {
  /** Returns the bounding sphere of some points about the centre of their bounding box. */
  static BoundingSphere around(float[] points) {
    double[] least = {0, 0, 0};
    double[] most = {0, 0, 0};
    for (int i = 0; i < points.length; i++) {
      int axis = i % 3;
      least[axis] = i < 3 ? points[i] : Math.min(least[axis], points[i]);
      most[axis] = i < 3 ? points[i] : Math.max(most[axis], points[i]);
    }
    double x = (least[0] + most[0]) / 2;
    double y = (least[1] + most[1]) / 2;
    double z = (least[2] + most[2]) / 2;
    double square = 0;
    for (int i = 0; i + 2 < points.length; i += 3) {
      double dx = points[i] - x;
      double dy = points[i + 1] - y;
      double dz = points[i + 2] - z;
      square = Math.max(square, dx * dx + dy * dy + dz * dz);
    }
    return new BoundingSphere(x, y, z, Math.max(Math.sqrt(square), 1e-9));
  }
}
