package org.selectiverenderer.x3d.tessellate;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Computes the matrix of a Transform node (X3D 4.0, 10.4.4). */
public final class TransformMatrix {
  private TransformMatrix() {}

  /**
   * Returns the parent's matrix times the matrix T C R SR S -SR -C of a Transform or CADPart, which
   * maps its children's coordinates.
   */
  public static Matrix4d of(NodeView transform, Matrix4dc parent) {
    return of(
        new Matrix4d(parent),
        transform.floats("translation"),
        transform.floats("center"),
        transform.floats("rotation"),
        transform.floats("scale"),
        transform.floats("scaleOrientation"));
  }

  /**
   * Multiplies a matrix by the matrix T C R SR S -SR -C of field values.
   *
   * @param matrix the parent's matrix, which is changed and returned
   * @param r a rotation axis of any length (0 means no rotation) and an angle in radians
   */
  public static Matrix4d of(
      Matrix4d matrix, float[] t, float[] c, float[] r, float[] s, float[] sr) {
    matrix.translate(t[0] + (double) c[0], t[1] + (double) c[1], t[2] + (double) c[2]);
    rotate(matrix, r, 1);
    rotate(matrix, sr, 1);
    matrix.scale(s[0], s[1], s[2]);
    rotate(matrix, sr, -1);
    return matrix.translate(-(double) c[0], -(double) c[1], -(double) c[2]);
  }

  /** Returns the matrix T R of a collidable node (X3D 4.0, 37.3.2). */
  static Matrix4d ofCollidable(NodeView collidable) {
    float[] t = collidable.floats("translation");
    Matrix4d matrix = new Matrix4d().translation(t[0], t[1], t[2]);
    rotate(matrix, collidable.floats("rotation"), 1);
    return matrix;
  }

  private static void rotate(Matrix4d matrix, float[] r, int sign) {
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    if (length > 0 && r[3] != 0) {
      matrix.rotate(sign * (double) r[3], r[0] / length, r[1] / length, r[2] / length);
    }
  }
}
