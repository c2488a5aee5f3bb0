package org.selectiverenderer.runtime.camera;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.viewer.Viewer;

/**
 * One eye's view and where it is drawn. Matrices are not written to after they are given.
 *
 * @param view from the world to the eye, which looks along -Z
 * @param projection from the eye to clip coordinates, depth -1..1
 * @param x left of the viewport in pixels
 * @param y bottom of the viewport in pixels
 * @param width of the viewport in pixels
 * @param height of the viewport in pixels
 */
public record Camera(Matrix4dc view, Matrix4dc projection, int x, int y, int width, int height) {

  /**
   * The viewer's view over a whole target of that size. Its field of view is the smaller of the two
   * viewing angles (X3D 4.0, 23.3.5).
   *
   * @param near distance of the near plane, above 0
   * @param far distance of the far plane, above {@code near}
   */
  public static Camera of(Viewer viewer, int width, int height, double near, double far) {
    double aspect = width / (double) height;
    double half = Math.tan(viewer.fieldOfView() / 2);
    double halfHeight = aspect >= 1 ? half : half / aspect;
    Matrix4d projection =
        new Matrix4d()
            .setFrustum(
                -halfHeight * aspect * near,
                halfHeight * aspect * near,
                -halfHeight * near,
                halfHeight * near,
                near,
                far);
    return new Camera(viewer.view(), projection, 0, 0, width, height);
  }

  /** The eye in world coordinates. */
  public Vector3dc eye() {
    return view.originAffine(new Vector3d());
  }
}
