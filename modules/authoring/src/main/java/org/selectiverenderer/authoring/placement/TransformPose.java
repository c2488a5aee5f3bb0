package org.selectiverenderer.authoring.placement;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The fields of a Transform (X3D 4.0, 10.4.4): it maps the coordinates of its children to those
 * around it by T C R SR S -SR -C.
 *
 * @param rotation of unit length
 * @param scaleOrientation of unit length
 */
public record TransformPose(
    Vector3dc translation,
    Vector3dc center,
    Quaterniondc rotation,
    Vector3dc scale,
    Quaterniondc scaleOrientation) {
  /** The pose that changes nothing. */
  public static final TransformPose IDENTITY =
      new TransformPose(
          new Vector3d(), new Vector3d(), new Quaterniond(), new Vector3d(1), new Quaterniond());

  /** Least factor of a scale, so that nothing vanishes for good. */
  private static final double LEAST = 1e-4;

  /** Copies the values. */
  public TransformPose {
    translation = new Vector3d(translation);
    center = new Vector3d(center);
    rotation = new Quaterniond(rotation);
    scale = new Vector3d(scale);
    scaleOrientation = new Quaterniond(scaleOrientation);
  }

  /** Reads the fields of a Transform; those that cannot be read have their default values. */
  public static TransformPose of(DocumentElement transform) {
    return new TransformPose(
        vector(transform, "translation", 0),
        vector(transform, "center", 0),
        rotation(transform, "rotation"),
        vector(transform, "scale", 1),
        rotation(transform, "scaleOrientation"));
  }

  private static Vector3d vector(DocumentElement of, String field, float otherwise) {
    float[] v =
        LocalCoordinateSystem.numbers(
            of, field, FieldType.SFVec3f, otherwise, otherwise, otherwise);
    return new Vector3d(v[0], v[1], v[2]);
  }

  private static Quaterniond rotation(DocumentElement of, String field) {
    return rotation(LocalCoordinateSystem.numbers(of, field, FieldType.SFRotation, 0, 0, 1, 0));
  }

  /** Returns the rotation of a value of type SFRotation: an axis and an angle. */
  static Quaterniond rotation(float[] r) {
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    return length > 0 // An axis 0 0 0 means no rotation.
        ? new Quaterniond().fromAxisAngleRad(r[0] / length, r[1] / length, r[2] / length, r[3])
        : new Quaterniond();
  }

  /** Returns the matrix from the children's coordinates to those around the Transform. */
  public Matrix4d matrix() {
    return new Matrix4d()
        .translate(translation.x() + center.x(), translation.y() + center.y(), at(2))
        .rotate(rotation)
        .rotate(scaleOrientation)
        .scale(scale)
        .rotate(scaleOrientation.conjugate(new Quaterniond()))
        .translate(-center.x(), -center.y(), -center.z());
  }

  private double at(int k) {
    return translation.get(k) + center.get(k);
  }

  /**
   * Returns the pose moved by a vector.
   *
   * @param shift in the coordinates around the Transform
   */
  public TransformPose movedBy(Vector3dc shift) {
    return new TransformPose(
        translation.add(shift, new Vector3d()), center, rotation, scale, scaleOrientation);
  }

  /**
   * Returns the pose turned about a point.
   *
   * @param turn in the coordinates around the Transform
   * @param pivot the point that stays, in these coordinates
   */
  public TransformPose turned(Quaterniondc turn, Vector3dc pivot) {
    Vector3d origin = new Vector3d(translation).add(center).sub(pivot);
    turn.transform(origin).add(pivot).sub(center);
    return new TransformPose(
        origin, center, turn.mul(rotation, new Quaterniond()).normalize(), scale, scaleOrientation);
  }

  /**
   * Returns the pose scaled along the axes of its scale.
   *
   * @param factors for each axis, above 0
   * @param fixed the point that stays, in the children's coordinates
   */
  public TransformPose scaled(Vector3dc factors, Vector3dc fixed) {
    Vector3d now = new Vector3d();
    for (int k = 0; k < 3; k++) {
      double wanted = scale.get(k) * factors.get(k);
      now.setComponent(k, Math.copySign(Math.max(LEAST, Math.abs(wanted)), scale.get(k)));
    }
    TransformPose larger = new TransformPose(translation, center, rotation, now, scaleOrientation);
    Vector3d before = matrix().transformPosition(new Vector3d(fixed));
    Vector3d after = larger.matrix().transformPosition(new Vector3d(fixed));
    return larger.movedBy(before.sub(after));
  }

  /**
   * Returns a pose with a matrix, which any matrix without a shadow (of determinant 0) has: its
   * linear part is a rotation times a scale along some axes (the polar decomposition).
   *
   * @param center the centre of the pose
   */
  public static TransformPose of(Matrix4dc matrix, Vector3dc center) {
    Matrix3d linear = new Matrix3d(matrix);
    boolean mirrored = linear.determinant() < 0;
    if (mirrored) {
      linear.scale(-1);
    }
    Matrix3d square = new Matrix3d(linear).transpose().mul(linear);
    double[][] rows = new double[3][3];
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        rows[row][column] = square.get(column, row);
      }
    }
    SymmetricEigen eigen = new SymmetricEigen(rows);
    Vector3d scale = new Vector3d();
    Matrix3d axes = new Matrix3d();
    for (int k = 0; k < 3; k++) {
      scale.setComponent(k, Math.sqrt(Math.max(0, eigen.value(k))));
      axes.setColumn(k, eigen.vector(k, 0), eigen.vector(k, 1), eigen.vector(k, 2));
    }
    if (axes.determinant() < 0) {
      axes.setColumn(2, axes.getColumn(2, new Vector3d()).negate());
    }
    Matrix3d stretch =
        new Matrix3d(axes).scale(scale).mul(axes.transpose(new Matrix3d()), new Matrix3d());
    Matrix3d turn = linear.mul(stretch.invert(), new Matrix3d());
    if (mirrored) {
      scale.negate();
    }
    Vector3d translation = matrix.transformPosition(new Vector3d(center)).sub(center);
    return new TransformPose(
        translation,
        center,
        new Quaterniond().setFromNormalized(turn).normalize(),
        scale,
        new Quaterniond().setFromNormalized(axes).normalize());
  }
}
