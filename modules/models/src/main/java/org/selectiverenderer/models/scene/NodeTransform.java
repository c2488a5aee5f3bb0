package org.selectiverenderer.models.scene;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * The place of a node: translation in metres, rotation as a unit quaternion x, y, z, w, and scale.
 *
 * @param sheared whether the node's matrix also shears, which is left out
 */
public record NodeTransform(
    double[] translation, double[] rotation, double[] scale, boolean sheared) {
  private static final double SHEAR = 1e-3;

  /** Returns a quaternion of length 1; no rotation for one of length 0. */
  public static double[] unit(double[] q) {
    double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return length > 0
        ? new double[] {q[0] / length, q[1] / length, q[2] / length, q[3] / length}
        : new double[] {0, 0, 0, 1};
  }

  /** Decomposes a matrix of 16 numbers in column-major order. */
  public static NodeTransform of(double... m) {
    double[] scale = new double[3];
    double[][] axes = new double[3][];
    for (int i = 0; i < 3; i++) {
      double[] axis = {m[4 * i], m[4 * i + 1], m[4 * i + 2]};
      scale[i] = Math.sqrt(dot(axis, axis));
      axes[i] = axis;
    }
    if (dot(cross(axes[0], axes[1]), axes[2]) < 0) {
      scale[0] = -scale[0]; // a mirror image
    }
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        axes[i][k] = scale[i] == 0 ? (i == k ? 1 : 0) : axes[i][k] / scale[i];
      }
    }
    double shear =
        Math.abs(dot(axes[0], axes[1]))
            + Math.abs(dot(axes[1], axes[2]))
            + Math.abs(dot(axes[0], axes[2]));
    boolean flat = scale[0] == 0 || scale[1] == 0 || scale[2] == 0;
    double[] place = {m[12], m[13], m[14]};
    return new NodeTransform(place, unit(quaternion(axes)), scale, shear > SHEAR && !flat);
  }

  /** Writes those attributes of a Transform that differ from their defaults. */
  public void write(X3dWriter out) {
    if (translation[0] != 0 || translation[1] != 0 || translation[2] != 0) {
      out.attribute("translation", Numbers.of(translation));
    }
    double[] turn = Numbers.axisAngle(rotation);
    if (turn[3] != 0) {
      out.attribute("rotation", Numbers.of(turn));
    }
    if (scale[0] != 1 || scale[1] != 1 || scale[2] != 1) {
      out.attribute("scale", Numbers.of(scale));
    }
  }

  /**
   * Returns by what a matrix multiplies lengths, on average of all directions; 1 where it leaves no
   * volume.
   */
  public static double averageScale(Matrix4dc matrix) {
    double scale = Math.cbrt(Math.abs(matrix.determinant3x3()));
    return scale > 0 && Double.isFinite(scale) ? scale : 1;
  }

  /** Returns the matrix. */
  public Matrix4d matrix() {
    return new Matrix4d()
        .translationRotateScale(
            translation[0],
            translation[1],
            translation[2],
            rotation[0],
            rotation[1],
            rotation[2],
            rotation[3],
            scale[0],
            scale[1],
            scale[2]);
  }

  /** Returns the quaternion of a rotation whose columns are axes (Shepperd 1978). */
  private static double[] quaternion(double[][] a) {
    double trace = a[0][0] + a[1][1] + a[2][2];
    if (trace > 0) {
      double s = 2 * Math.sqrt(1 + trace);
      return new double[] {
        (a[1][2] - a[2][1]) / s, (a[2][0] - a[0][2]) / s, (a[0][1] - a[1][0]) / s, s / 4
      };
    }
    int i = a[0][0] >= a[1][1] && a[0][0] >= a[2][2] ? 0 : a[1][1] >= a[2][2] ? 1 : 2;
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double s = 2 * Math.sqrt(Math.max(1e-12, 1 + a[i][i] - a[j][j] - a[k][k]));
    double[] q = new double[4];
    q[i] = s / 4;
    q[j] = (a[i][j] + a[j][i]) / s;
    q[k] = (a[i][k] + a[k][i]) / s;
    q[3] = (a[j][k] - a[k][j]) / s;
    return q;
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }
}
