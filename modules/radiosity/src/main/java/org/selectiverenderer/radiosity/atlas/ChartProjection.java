package org.selectiverenderer.radiosity.atlas;

/**
 * Orthogonal projection of a body's triangles onto the plane perpendicular to a chart's axis. Its
 * origin is a vertex of the body, so that bodies far from the scene's origin keep their precision.
 */
final class ChartProjection {
  private final TriangleAdjacency body;
  private final double[] origin = new double[3];
  private final double[] right = new double[3];
  private final double[] up = new double[3];

  ChartProjection(TriangleAdjacency body) {
    this.body = body;
    for (int axis = 0; axis < 3 && body.triangles() > 0; axis++) {
      origin[axis] = body.coordinate(0, 0, axis);
    }
  }

  /** Sets the axis to the unit vector that begins at {@code at}. */
  void face(double[] axes, int at) {
    double x = axes[at];
    double y = axes[at + 1];
    double z = axes[at + 2];
    // The horizontal direction at right angles to the axis; for charts that face up or down, one at
    // right angles to z.
    boolean level = Math.abs(y) > 0.9;
    right[0] = level ? y : z;
    right[1] = level ? -x : 0;
    right[2] = level ? 0 : -x;
    double length = Math.sqrt(right[0] * right[0] + right[1] * right[1] + right[2] * right[2]);
    for (int axis = 0; axis < 3; axis++) {
      right[axis] /= length;
    }
    up[0] = y * right[2] - z * right[1];
    up[1] = z * right[0] - x * right[2];
    up[2] = x * right[1] - y * right[0];
  }

  double x(int triangle, int corner) {
    return along(right, triangle, corner);
  }

  double y(int triangle, int corner) {
    return along(up, triangle, corner);
  }

  private double along(double[] direction, int triangle, int corner) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      sum += direction[axis] * (body.coordinate(triangle, corner, axis) - origin[axis]);
    }
    return sum;
  }
}
