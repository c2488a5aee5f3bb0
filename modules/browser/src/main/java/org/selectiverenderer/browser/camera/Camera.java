package org.selectiverenderer.browser.camera;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.OrthographicExtent;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * A camera with its viewport. The matrices must not be changed after construction.
 *
 * @param view the view matrix: from world to eye coordinates; the eye looks along -Z
 * @param projection the projection matrix: from eye to clip coordinates, depth -1..1
 * @param x the viewport's left edge in pixels
 * @param y the viewport's bottom edge in pixels
 * @param width the viewport's width in pixels
 * @param height the viewport's height in pixels
 */
public record Camera(Matrix4dc view, Matrix4dc projection, int x, int y, int width, int height) {

  /**
   * Distance of the substitute eye of an orthographic view, in units of its depth: so far back that
   * the remaining perspective is below float precision.
   */
  private static final double FAR_BACK = 1e7;

  /**
   * Makes the viewer's camera for a render target of the given size. The viewer's field of view is
   * the smaller of the two viewing angles (X3D 4.0, 23.3.5); the extent of an orthographic view
   * grows until it fills the target.
   *
   * @param near the distance of the near plane, above 0
   * @param far the distance of the far plane, above {@code near}
   */
  public static Camera of(Viewer viewer, int width, int height, double near, double far) {
    double aspect = width / (double) height;
    Optional<OrthographicExtent> parallel = viewer.extent();
    if (parallel.isPresent()) {
      OrthographicExtent shown = parallel.get().filling(aspect);
      Matrix4d flat =
          new Matrix4d()
              .setOrtho(shown.left(), shown.right(), shown.bottom(), shown.top(), near, far);
      return new Camera(viewer.view(), flat, 0, 0, width, height);
    }
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

  /**
   * Returns the cross-section of the view frustum at distance 1, centred on the view axis; empty
   * for an orthographic view.
   */
  public Optional<OrthographicExtent> angle() {
    double x = 1 / projection.m00();
    double y = 1 / projection.m11();
    return parallel() ? Optional.empty() : Optional.of(new OrthographicExtent(-x, -y, x, y));
  }

  /** Returns whether the projection is orthographic. */
  public boolean parallel() {
    return projection.m33() != 0;
  }

  /**
   * Returns the eye in world coordinates; for an orthographic view, a point so far back that its
   * view is practically the same.
   */
  public Vector3dc eye() {
    return parallel()
        ? view.invertAffine(new Matrix4d())
            .transformPosition(new Vector3d(0, 0, FAR_BACK * depth()))
        : view.originAffine(new Vector3d());
  }

  /** Returns the distance between the near and far plane of an orthographic view. */
  private double depth() {
    return Math.abs(2 / projection.m22());
  }
}
