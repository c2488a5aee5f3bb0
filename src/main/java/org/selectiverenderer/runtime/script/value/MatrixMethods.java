package org.selectiverenderer.runtime.script.value;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * What the methods of matrices calculate. Components stand row by row, and vectors are rows: a
 * translation is the last row (ISO/IEC 19777-1, SFMatrix4). JOML writes columns and multiplies from
 * the other side, so that the same sixteen numbers mean the same transformation.
 */
final class MatrixMethods {
  private final int size;

  MatrixMethods(FieldType type) {
    size = type.components() == 16 ? 4 : 3;
  }

  double[] inverse(double[] m) {
    return size == 4
        ? new Matrix4d().set(m).invert().get(new double[16])
        : new Matrix3d().set(m).invert().get(new double[9]);
  }

  double[] transpose(double[] m) {
    double[] result = new double[m.length];
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        result[column * size + row] = m[row * size + column];
      }
    }
    return result;
  }

  double determinant(double[] m) {
    return size == 4 ? new Matrix4d().set(m).determinant() : new Matrix3d().set(m).determinant();
  }

  double[] product(double[] a, double[] b) {
    double[] result = new double[a.length];
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        for (int k = 0; k < size && k * size + column < b.length; k++) {
          result[row * size + column] += a[row * size + k] * b[k * size + column];
        }
      }
    }
    return result;
  }

  /** A row vector times a matrix; one that is a component short is a point. */
  double[] rowTimes(double[] vector, double[] m) {
    double[] row = new double[size];
    for (int column = 0; column < size; column++) {
      for (int k = 0; k < size; k++) {
        row[column] += (k < vector.length ? vector[k] : 1) * m[k * size + column];
      }
    }
    double[] result = new double[vector.length];
    double divisor = vector.length < size && row[size - 1] != 0 ? row[size - 1] : 1;
    for (int i = 0; i < Math.min(result.length, size); i++) {
      result[i] = row[i] / divisor;
    }
    return result;
  }

  private static double @Nullable [] argument(Object[] args, int index) {
    return index >= args.length || args[index] == null || Undefined.isUndefined(args[index])
        ? null
        : Constructors.tuple(args[index]).components();
  }

  /** {@code setTransform(translation, rotation, scale, scaleOrientation, center)}, any left out. */
  static double[] transform(Object[] args) {
    double[] translation = argument(args, 0);
    double[] rotation = argument(args, 1);
    double[] scale = argument(args, 2);
    double[] orientation = argument(args, 3);
    double[] center = argument(args, 4);
    Quaterniond tilt = orientation == null ? new Quaterniond() : Spatial.quaternion(orientation);
    Matrix4d matrix = new Matrix4d();
    if (translation != null) {
      matrix.translate(translation[0], translation[1], translation[2]);
    }
    if (center != null) {
      matrix.translate(center[0], center[1], center[2]);
    }
    if (rotation != null) {
      matrix.rotate(Spatial.quaternion(rotation));
    }
    matrix.rotate(tilt);
    if (scale != null) {
      matrix.scale(scale[0], scale[1], scale[2]);
    }
    matrix.rotate(tilt.conjugate(new Quaterniond()));
    if (center != null) {
      matrix.translate(-center[0], -center[1], -center[2]);
    }
    return matrix.get(new double[16]);
  }

  /** {@code getTransform}: writes translation, rotation and scale into the objects given. */
  static void taken(double[] m, Object[] args) {
    Matrix4d matrix = new Matrix4d().set(m);
    if (argument(args, 0) != null) {
      Vector3d translation = matrix.getTranslation(new Vector3d());
      Constructors.tuple(args[0]).set(translation.x, translation.y, translation.z);
    }
    if (argument(args, 1) != null) {
      Quaterniond rotation = matrix.getUnnormalizedRotation(new Quaterniond()).normalize();
      Constructors.tuple(args[1]).set(Spatial.axisAngle(rotation));
    }
    if (argument(args, 2) != null) {
      Vector3d scale = matrix.getScale(new Vector3d());
      Constructors.tuple(args[2]).set(scale.x, scale.y, scale.z);
    }
  }
}
