package org.selectiverenderer.render.occlusion;

import org.joml.Matrix4dc;
import org.joml.Vector3dc;

/**
 * Bounds of the rounding errors of OpenGL's vertex processing and rasterisation. Vertex shaders
 * compute with 24-bit mantissas; the error grows with the magnitude of the sums' terms.
 */
final class RasterErrorBounds {
  /**
   * The bound in pixels: corners are snapped to sub-pixels, at worst 1/32 of a pixel; the rest is
   * for the vertex shader.
   */
  static final double PIXELS = 0.5;

  /** The relative error of the vertex shader's positions. */
  private static final double SHADER = 0x1p-19;

  /**
   * The absolute error of the depth buffer (24 bits of -1..1) and of interpolation over a triangle:
   * 16 steps.
   */
  private static final double DEPTH_STEPS = 0x1p-19;

  private static final double DEPTH_SHADER = 0x1p-20;

  private RasterErrorBounds() {}

  /** Returns the largest distance of a point of a box (minima, maxima) from the origin. */
  static double reach(float[] box) {
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      double far = Math.max(Math.abs(box[axis]), Math.abs(box[axis + 3]));
      sum += far * far;
    }
    return Math.sqrt(sum);
  }

  /**
   * Returns a bound of the sums of absolute values that occur on the way from local to the eye's
   * coordinates (the terms of a shape).
   *
   * @param reach the largest distance of the mesh from its origin
   */
  static double terms(Matrix4dc world, double reach, Vector3dc eye) {
    double x = world.m30() - eye.x();
    double y = world.m31() - eye.y();
    double z = world.m32() - eye.z();
    return Math.sqrt(3) * (norm(world) * reach + Math.sqrt(x * x + y * y + z * z))
        // Covers vertices that are stored, and so rounded, in world coordinates.
        + Math.abs(world.m30())
        + Math.abs(world.m31())
        + Math.abs(world.m32());
  }

  /** Returns a bound of {@link #terms} for an eye at the origin of the world. */
  static double terms(Matrix4dc world, double reach) {
    double x = world.m30();
    double y = world.m31();
    double z = world.m32();
    return Math.sqrt(3) * (norm(world) * reach + Math.sqrt(x * x + y * y + z * z))
        + Math.abs(x)
        + Math.abs(y)
        + Math.abs(z);
  }

  /** Returns a bound of the terms of a shape for another eye than that at the origin. */
  static double terms(double atOrigin, Vector3dc eye) {
    return atOrigin + Math.sqrt(3) * eye.length();
  }

  /** Returns the Frobenius norm of the linear part. */
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
   * Returns the depth beyond which a shape with these terms is drawn to within half of {@link
   * #PIXELS}.
   *
   * @param focal the focal length: pixels per unit at depth 1
   */
  static double sharpFrom(double terms, double focal) {
    return terms * SHADER * focal;
  }

  /** Returns the absolute error of 1 / depth; {@code perspective} is the matrix's m32. */
  static double depthLoss(double perspective) {
    return DEPTH_STEPS / Math.abs(perspective);
  }

  /** Returns the relative error of 1 / depth. */
  static double depthLoss(double perspective, double terms) {
    return DEPTH_SHADER * (1 + terms / Math.abs(perspective));
  }

  /**
   * Returns an upper bound of the factor by which a matrix stretches lengths, exact without shear.
   */
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
