package org.selectiverenderer.browser;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.viewer.Viewer;

/** Maps the pointing device's direction in the whole picture to a layer's part of the picture. */
final class LayerPointerMapping {
  private LayerPointerMapping() {}

  /**
   * Returns the pointer as the viewer of a layer sees it; {@link PointingDeviceState#AWAY} where it
   * points outside the layer's part of the picture.
   *
   * @param pointer the pointer in the frame of the viewer of the whole picture
   * @param layer the viewer of the layer
   */
  static PointingDeviceState in(
      LayerView.Part part, Viewer layer, PointingDeviceState pointer, Viewer whole) {
    Optional<Vector3dc> direction =
        pointer.direction().flatMap(at -> direction(part, layer, at, whole, pointer.aspect()));
    return new PointingDeviceState(
        direction, pointer.pressed(), pointer.aspect() * part.width() / part.height());
  }

  private static Optional<Vector3dc> direction(
      LayerView.Part part, Viewer layer, Vector3dc at, Viewer whole, double aspect) {
    if (at.z() >= 0) {
      return Optional.empty();
    }
    // Position in the picture: 0 is its middle, -1 and 1 are its edges.
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
