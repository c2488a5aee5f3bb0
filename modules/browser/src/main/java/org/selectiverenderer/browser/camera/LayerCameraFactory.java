package org.selectiverenderer.browser.camera;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * Makes the camera of a layer that is not the active one, or that is drawn into a part of the
 * picture (X3D 4.0, 35.2.2).
 */
public final class LayerCameraFactory {
  private LayerCameraFactory() {}

  /**
   * Makes a layer's camera for one of the views of a frame. The eyes have the same offset from the
   * layer's viewer as from the user. A display's own frustum takes precedence over the layer's
   * viewpoint, unless that is orthographic.
   *
   * @param of the camera of the active layer for the whole picture
   * @param user the viewer of the active layer
   * @param mono whether the view is the viewer's own; otherwise a display dictates it
   * @param range the near and far plane for the layer
   */
  public static Camera of(Camera of, Viewer user, LayerView layer, boolean mono, DepthRange range) {
    LayerView.Part part = layer.part();
    int left = (int) Math.round(part.left() * of.width());
    int bottom = (int) Math.round(part.bottom() * of.height());
    int width = Math.max(1, (int) Math.round(part.right() * of.width()) - left);
    int height = Math.max(1, (int) Math.round(part.top() * of.height()) - bottom);
    Camera own = Camera.of(layer.viewer(), width, height, range.near(), range.far());
    boolean asViewer = mono || own.parallel();
    Matrix4d beside = of.view().mul(user.view().invertAffine(), new Matrix4d());
    return new Camera(
        asViewer ? own.view() : beside.mul(own.view()),
        asViewer ? own.projection() : frustum(of.projection(), range),
        of.x() + left,
        of.y() + bottom,
        width,
        height);
  }

  /** Returns the same frustum with another near and far plane. */
  private static Matrix4d frustum(Matrix4dc projection, DepthRange range) {
    double depth = range.far() - range.near();
    return new Matrix4d(projection)
        .m22(-(range.far() + range.near()) / depth)
        .m32(-2 * range.far() * range.near() / depth);
  }
}
