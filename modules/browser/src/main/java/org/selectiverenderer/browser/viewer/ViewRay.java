package org.selectiverenderer.browser.viewer;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A line of sight in world coordinates.
 *
 * @param direction the direction, of any length
 */
public record ViewRay(Vector3dc origin, Vector3dc direction) {

  /**
   * Returns the line of sight through a point of the picture: from the eye, or, in an orthographic
   * view, from the corresponding point beside it.
   *
   * @param direction the direction of that point in the viewer's frame, for a perspective view with
   *     the same field of view
   * @param aspect the aspect ratio of the picture, width to height
   */
  public static ViewRay of(Viewer viewer, Vector3dc direction, double aspect) {
    Optional<OrthographicExtent> parallel = viewer.extent();
    if (parallel.isEmpty()) {
      return new ViewRay(
          new Vector3d(viewer.position()),
          viewer.orientation().transform(direction, new Vector3d()));
    }
    OrthographicExtent shown = parallel.get().filling(aspect);
    // In units of half the smaller side of the picture, from its centre.
    double unit = Math.tan(viewer.fieldOfView() / 2) * -direction.z();
    double half = Math.min(shown.right() - shown.left(), shown.top() - shown.bottom()) / 2;
    Vector3d beside =
        new Vector3d(
            (shown.left() + shown.right()) / 2 + direction.x() / unit * half,
            (shown.bottom() + shown.top()) / 2 + direction.y() / unit * half,
            0);
    return new ViewRay(
        viewer.orientation().transform(beside).add(viewer.position()),
        viewer.orientation().transform(new Vector3d(0, 0, -1)));
  }
}
