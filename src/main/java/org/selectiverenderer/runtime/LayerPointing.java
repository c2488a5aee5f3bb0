package org.selectiverenderer.runtime;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.viewer.Viewer;

/** Takes what the pointing device says of the whole picture into the part of a layer. */
final class LayerPointing {
  private LayerPointing() {}

  /**
   * The same in a layer; away where it points beside its part.
   *
   * @param pointer as the viewer of the whole picture sees it
   * @param layer who sees the layer
   */
  static Pointer in(LayerView.Part part, Viewer layer, Pointer pointer, Viewer whole) {
    Optional<Vector3dc> direction =
        pointer.direction().flatMap(at -> direction(part, layer, at, whole, pointer.aspect()));
    return new Pointer(
        direction, pointer.pressed(), pointer.aspect() * part.width() / part.height());
  }

  private static Optional<Vector3dc> direction(
      LayerView.Part part, Viewer layer, Vector3dc at, Viewer whole, double aspect) {
    if (at.z() >= 0) {
      return Optional.empty();
    }
    // From the middle of the picture to its edges, -1..1.
    double unit = Math.tan(whole.fieldOfView() / 2) * -at.z();
    double x = at.x() / unit * Math.min(1, 1 / aspect);
    double y = at.y() / unit * Math.min(1, aspect);
    double inX = 2 * ((x + 1) / 2 - part.left()) / part.width() - 1;
    double inY = 2 * ((y + 1) / 2 - part.bottom()) / part.height() - 1;
    if (Math.abs(inX) > 1 || Math.abs(inY) > 1) {
      return Optional.empty();
    }
    double partAspect = aspect * part.width() / part.height();
    double half = Math.tan(layer.fieldOfView() / 2);
    return Optional.of(
        new Vector3d(
            inX * half * Math.max(1, partAspect), inY * half * Math.max(1, 1 / partAspect), -1));
  }
}
