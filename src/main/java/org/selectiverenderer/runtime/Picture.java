package org.selectiverenderer.runtime;

import java.util.Optional;
import org.selectiverenderer.runtime.nodes.layout.Sight;
import org.selectiverenderer.runtime.viewer.Extent;
import org.selectiverenderer.runtime.viewer.Viewer;

/**
 * The size of the picture that a world is seen in: of one eye's where there are two.
 *
 * @param width in pixels of the desktop, above 0
 * @param height in pixels of the desktop, above 0
 * @param frustum of a display that shows another angle than the viewer's: what is seen at a
 *     distance of 1
 */
record Picture(double width, double height, Optional<Extent> frustum) {
  /**
   * What is assumed where no picture is drawn: that of a window; as wide to high as {@link
   * WorldFrame} assumes.
   */
  static final Picture DEFAULT = new Picture(1024, 768, Optional.empty());

  /** What a viewer sees in a part of it. */
  Sight sight(Viewer viewer, LayerView.Part part) {
    double wide = width * part.width();
    double high = height * part.height();
    double aspect = wide / high;
    Optional<Extent> parallel = viewer.extent().map(extent -> extent.filling(aspect));
    double half = Math.tan(viewer.fieldOfView() / 2);
    Extent seen =
        parallel
            .or(() -> frustum)
            .orElseGet(
                () -> {
                  double x = half * Math.max(1, aspect);
                  double y = half * Math.max(1, 1 / aspect);
                  return new Extent(-x, -y, x, y);
                });
    return new Sight(
        viewer.view(),
        parallel.isPresent(),
        seen.left(),
        seen.right(),
        seen.bottom(),
        seen.top(),
        wide,
        high);
  }
}
