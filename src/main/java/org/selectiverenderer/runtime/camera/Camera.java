package org.selectiverenderer.runtime.camera;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.viewer.Extent;
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

  /** Depths of a parallel view: sizes of floats hide the angle that is left. */
  private static final double FAR_BACK = 1e7;

  /**
   * The viewer's view over a whole target of that size. Its field of view is the smaller of the two
   * viewing angles (X3D 4.0, 23.3.5); in a parallel view both grow that it fills the target.
   *
   * @param near distance of the near plane, above 0
   * @param far distance of the far plane, above {@code near}
   */
  public static Camera of(Viewer viewer, int width, int height, double near, double far) {
    double aspect = width / (double) height;
    Optional<Extent> parallel = viewer.extent();
    if (parallel.isPresent()) {
      Extent shown = parallel.get().filling(aspect);
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

  /** What is seen at a distance of 1, as if the eye looked at its middle; empty if parallel. */
  public Optional<Extent> angle() {
    double x = 1 / projection.m00();
    double y = 1 / projection.m11();
    return parallel() ? Optional.empty() : Optional.of(new Extent(-x, -y, x, y));
  }

  /** Whether lines of sight are parallel. */
  public boolean parallel() {
    return projection.m33() != 0;
  }

  /** The eye in world coordinates; that of a parallel view is so far back that it sees likewise. */
  public Vector3dc eye() {
    return parallel()
        ? view.invertAffine(new Matrix4d())
            .transformPosition(new Vector3d(0, 0, FAR_BACK * depth()))
        : view.originAffine(new Vector3d());
  }

  /** How deep a parallel view reaches. */
  private double depth() {
    return Math.abs(2 / projection.m22());
  }
}
