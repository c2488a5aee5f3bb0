package org.selectiverenderer.runtime.camera;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.LayerView;
import org.selectiverenderer.runtime.viewer.Viewer;

/**
 * The camera of a layer that is not the one the user walks in, or is drawn into a part of the
 * picture (X3D 4.0, 35.2.2).
 */
public final class LayerCamera {
  private LayerCamera() {}

  /**
   * A layer's camera for one of the views of a frame. Eyes are beside the layer's viewer as they
   * are beside the user; a display has its own frustum, whatever the layer's viewpoint says, unless
   * that is a parallel one.
   *
   * @param of the view of the active layer over the whole picture
   * @param user the viewer of the active layer
   * @param mono whether the view is the viewer's own, else one that a display wants
   * @param range of depths in the layer
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

  /** The same frustum with other depths. */
  private static Matrix4d frustum(Matrix4dc projection, DepthRange range) {
    double depth = range.far() - range.near();
    return new Matrix4d(projection)
        .m22(-(range.far() + range.near()) / depth)
        .m32(-2 * range.far() * range.near() / depth);
  }
}
