package org.selectiverenderer.runtime.render.occlude;

import org.joml.Matrix4dc;
import org.joml.Vector3dc;

/**
 * How far a picture may be from exact arithmetic. OpenGL's vertex shader computes in 24 bits; how
 * much is lost grows with the numbers that it adds up, here called terms.
 */
final class Precision {
  /** Corners go to sub-pixels, at worst 1/32 of a pixel; the rest is for the vertex shader. */
  static final double PIXELS = 0.5;

  /** The share of a pixel's size, per term and depth, that the vertex shader may lose. */
  private static final double SHADER = 0x1p-19;

  /** Of the depth buffer, 24 bits of -1..1, and of interpolation over a triangle: 16 steps. */
  private static final double DEPTH_STEPS = 0x1p-19;

  private static final double DEPTH_SHADER = 0x1p-20;

  private Precision() {}

  /** The distance from the origin that no point of a box (minima, maxima) exceeds. */
  static double reach(float[] box) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double far = Math.max(Math.abs(box[axis]), Math.abs(box[axis + 3]));
      sum += far * far;
    }
    return Math.sqrt(sum);
  }

  /**
   * The terms of a shape: no sum of absolute values on the way from local to the eye's coordinates
   * exceeds it.
   *
   * @param reach of the mesh
   */
  static double terms(Matrix4dc world, double reach, Vector3dc eye) {
    double x = world.m30() - eye.x();
    double y = world.m31() - eye.y();
    double z = world.m32() - eye.z();
    return Math.sqrt(3) * (norm(world) * reach + Math.sqrt(x * x + y * y + z * z))
        // Should corners be kept in world coordinates, they are rounded there.
        + Math.abs(world.m30())
        + Math.abs(world.m31())
        + Math.abs(world.m32());
  }

  /** The Frobenius norm of the linear part. */
  private static double norm(Matrix4dc m) {
    return Math.sqrt(
        m.m00() * m.m00()
            + m.m01() * m.m01()
            + m.m02() * m.m02()
            + m.m10() * m.m10()
            + m.m11() * m.m11()
            + m.m12() * m.m12()
            + m.m20() * m.m20()
            + m.m21() * m.m21()
            + m.m22() * m.m22());
  }

  /**
   * The depth from which on what has these terms is drawn to within half of {@link #PIXELS}.
   *
   * @param focal pixels per unit at depth 1
   */
  static double sharpFrom(double terms, double focal) {
    return terms * SHADER * focal;
  }

  /** What of 1 / depth is lost whatever the depth; {@code perspective} is the matrix's m32. */
  static double depthLoss(double perspective) {
    return DEPTH_STEPS / Math.abs(perspective);
  }

  /** What of 1 / depth is lost in proportion to it. */
  static double depthLoss(double perspective, double terms) {
    return DEPTH_SHADER * (1 + terms / Math.abs(perspective));
  }

  /** The largest factor by which a matrix stretches a length, or a little more if it shears. */
  static double stretch(Matrix4dc m) {
    double xx = m.m00() * m.m00() + m.m01() * m.m01() + m.m02() * m.m02();
    double yy = m.m10() * m.m10() + m.m11() * m.m11() + m.m12() * m.m12();
    double zz = m.m20() * m.m20() + m.m21() * m.m21() + m.m22() * m.m22();
    double xy = Math.abs(m.m00() * m.m10() + m.m01() * m.m11() + m.m02() * m.m12());
    double xz = Math.abs(m.m00() * m.m20() + m.m01() * m.m21() + m.m02() * m.m22());
    double yz = Math.abs(m.m10() * m.m20() + m.m11() * m.m21() + m.m12() * m.m22());
    // The largest row sum bounds the largest eigenvalue of the product with the transpose.
    return Math.sqrt(Math.max(xx + xy + xz, Math.max(yy + xy + yz, zz + xz + yz)));
  }
}
