package org.selectiverenderer.render.draw;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector4d;
import org.selectiverenderer.browser.camera.Camera;

/**
 * The six planes of a camera's view frustum with unit normals pointing inwards. In double
 * precision, so that scenes far from the origin are culled as exactly as those near it.
 */
final class Frustum {
  private static final int PLANES = 6;
  private final double[] planes = new double[4 * PLANES];

  /** Makes a frustum whose planes are set later. */
  Frustum() {}

  static Frustum of(Camera camera) {
    Matrix4d clip = camera.projection().mul(camera.view(), new Matrix4d());
    Frustum frustum = new Frustum();
    Vector4d plane = new Vector4d();
    for (int i = 0; i < PLANES; i++) {
      clip.frustumPlane(i, plane);
      frustum.put(i, plane.x, plane.y, plane.z, plane.w);
    }
    return frustum;
  }

  /**
   * Transforms the planes to local coordinates.
   *
   * @param world the matrix from local to this frustum's coordinates
   * @param local receives the result
   */
  Frustum local(Matrix4dc world, Frustum local) {
    for (int i = 0; i < PLANES; i++) {
      double a = planes[4 * i];
      double b = planes[4 * i + 1];
      double c = planes[4 * i + 2];
      local.put(
          i,
          a * world.m00() + b * world.m01() + c * world.m02(),
          a * world.m10() + b * world.m11() + c * world.m12(),
          a * world.m20() + b * world.m21() + c * world.m22(),
          a * world.m30() + b * world.m31() + c * world.m32() + planes[4 * i + 3]);
    }
    return local;
  }

  private void put(int i, double a, double b, double c, double d) {
    double length = Math.sqrt(a * a + b * b + c * c);
    double scale = length > 0 ? 1 / length : 1;
    planes[4 * i] = a * scale;
    planes[4 * i + 1] = b * scale;
    planes[4 * i + 2] = c * scale;
    planes[4 * i + 3] = d * scale;
  }

  /** The position of a box relative to the frustum. */
  enum Side {
    OUTSIDE,
    ACROSS,
    INSIDE
  }

  /**
   * Classifies a box; one near a corner of the frustum may count as {@link Side#ACROSS} although it
   * is outside.
   *
   * @param box min x, y, z, max x, y, z
   */
  Side side(double[] box) {
    Side side = Side.INSIDE;
    for (int i = 0; i < planes.length; i += 4) {
      double far = planes[i + 3];
      double near = far;
      for (int axis = 0; axis < 3; axis++) {
        double n = planes[i + axis];
        far += n * (n > 0 ? box[axis + 3] : box[axis]);
        near += n * (n > 0 ? box[axis] : box[axis + 3]);
      }
      if (far < 0) {
        return Side.OUTSIDE;
      }
      if (near < 0) {
        side = Side.ACROSS;
      }
    }
    return side;
  }

  /** Returns whether a sphere lies completely outside of one of the planes. */
  boolean outside(float[] spheres, int at) {
    for (int i = 0; i < planes.length; i += 4) {
      double distance =
          planes[i] * spheres[at]
              + planes[i + 1] * spheres[at + 1]
              + planes[i + 2] * spheres[at + 2]
              + planes[i + 3];
      if (distance < -spheres[at + 3]) {
        return true;
      }
    }
    return false;
  }
}
