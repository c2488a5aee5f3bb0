package org.selectiverenderer.apparatus;

import org.joml.Matrix4d;
import org.joml.Vector2d;
import org.joml.Vector3dc;

/**
 * The view frustum of one eye, as tangents of the angles from its view axis to the four sides of
 * its picture. The axis points along -Z and need not meet the picture's centre (off-axis frustum).
 *
 * @param left usually below 0
 * @param right above {@code left}
 * @param bottom usually below 0
 * @param top above {@code bottom}
 */
public record EyeFrustum(double left, double right, double bottom, double top) {

  /**
   * Returns the projection matrix from the eye's coordinates to clip coordinates, depth -1..1.
   *
   * @param near above 0
   * @param far above {@code near}
   */
  public Matrix4d projection(double near, double far) {
    return new Matrix4d()
        .setFrustum(left * near, right * near, bottom * near, top * near, near, far);
  }

  /**
   * Projects a point to the picture: x and y from -1 (left, bottom) to 1 (right, top).
   *
   * @param point in the eye's coordinates, in front of it (z below 0)
   */
  public Vector2d project(Vector3dc point) {
    double x = point.x() / -point.z();
    double y = point.y() / -point.z();
    return new Vector2d(
        (2 * x - right - left) / (right - left), (2 * y - top - bottom) / (top - bottom));
  }
}
