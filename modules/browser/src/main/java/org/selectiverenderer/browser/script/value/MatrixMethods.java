package org.selectiverenderer.browser.script.value;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The computations of matrix methods. Components are in row-major order, and vectors are rows: a
 * translation is the last row (ISO/IEC 19777-1, SFMatrix4). JOML uses column-major order and column
 * vectors, so that the same sixteen numbers mean the same transformation.
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

  /**
   * Multiplies a row vector by a matrix; a vector with one component less than the matrix is a
   * point.
   */
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
        : FieldConstructors.tuple(args[index]).components();
  }

  /**
   * Computes {@code setTransform(translation, rotation, scale, scaleOrientation, center)}; all
   * arguments are optional. For SFMatrix3 the vectors are SFVec2 and the rotations SFVec3, whose
   * meaning the standard does not define: the last component is taken as the angle. A number is
   * taken as the angle, too.
   */
  double[] transform(Object[] args) {
    Vector3d translation = vector(argument(args, 0), 0);
    Quaterniond rotation = rotation(args, 1);
    Vector3d scale = vector(argument(args, 2), 1);
    Quaterniond tilt = rotation(args, 3);
    Vector3d center = vector(argument(args, 4), 0);
    double[] m =
        new Matrix4d()
            .translate(translation)
            .translate(center)
            .rotate(rotation)
            .rotate(tilt)
            .scale(scale)
            .rotate(tilt.conjugate(new Quaterniond()))
            .translate(center.negate())
            .get(new double[16]);
    return size == 4 ? m : new double[] {m[0], m[1], 0, m[4], m[5], 0, m[12], m[13], 1};
  }

  private static Vector3d vector(double @Nullable [] given, double unlessGiven) {
    return given == null
        ? new Vector3d(unlessGiven)
        : new Vector3d(given[0], given[1], given.length > 2 ? given[2] : unlessGiven);
  }

  private Quaterniond rotation(Object[] args, int index) {
    if (size == 3 && index < args.length && args[index] instanceof Number angle) {
      return new Quaterniond().rotationZ(angle.doubleValue());
    }
    double[] given = argument(args, index);
    return given == null
        ? new Quaterniond()
        : size == 3
            ? new Quaterniond().rotationZ(given[given.length - 1])
            : VectorMath.quaternion(given);
  }

  /**
   * Computes {@code getTransform}: writes translation, rotation and scale into the objects given.
   */
  void taken(double[] m, Object[] args) {
    Matrix4d matrix = size == 4 ? new Matrix4d().set(m) : ofPlane(m);
    if (argument(args, 0) != null) {
      give(args[0], matrix.getTranslation(new Vector3d()));
    }
    if (argument(args, 1) != null) {
      Quaterniond rotation = matrix.getUnnormalizedRotation(new Quaterniond()).normalize();
      if (size == 4) {
        FieldConstructors.tuple(args[1]).set(VectorMath.axisAngle(rotation));
      } else {
        FieldConstructors.tuple(args[1]).set(0, 0, 2 * Math.atan2(rotation.z, rotation.w));
      }
    }
    if (argument(args, 2) != null) {
      give(args[2], matrix.getScale(new Vector3d()));
    }
  }

  private static Matrix4d ofPlane(double[] m) {
    return new Matrix4d(m[0], m[1], 0, 0, m[3], m[4], 0, 0, 0, 0, 1, 0, m[6], m[7], 0, 1);
  }

  private void give(Object to, Vector3d vector) {
    if (size == 4) {
      FieldConstructors.tuple(to).set(vector.x, vector.y, vector.z);
    } else {
      FieldConstructors.tuple(to).set(vector.x, vector.y);
    }
  }
}
