package org.selectiverenderer.browser;

import java.util.Optional;
import org.selectiverenderer.browser.nodes.layout.ViewParameters;
import org.selectiverenderer.browser.viewer.OrthographicExtent;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * The size of the picture in which a world is seen; in stereo, of one eye's picture.
 *
 * @param width the picture's width in desktop pixels, above 0
 * @param height the picture's height in desktop pixels, above 0
 * @param frustum the cross-section of the display's view frustum at distance 1, for displays whose
 *     viewing angle differs from the viewer's
 */
record DisplayMetrics(double width, double height, Optional<OrthographicExtent> frustum) {
  /**
   * The size assumed while nothing is drawn; its aspect ratio is the one that {@link
   * WorldFrameContext} assumes.
   */
  static final DisplayMetrics DEFAULT = new DisplayMetrics(1024, 768, Optional.empty());

  /** Returns the view parameters of a viewer for a part of the picture. */
  ViewParameters sight(Viewer viewer, LayerView.Part part) {
    double wide = width * part.width();
    double high = height * part.height();
    double aspect = wide / high;
    Optional<OrthographicExtent> parallel = viewer.extent().map(extent -> extent.filling(aspect));
    double half = Math.tan(viewer.fieldOfView() / 2);
    OrthographicExtent seen =
        parallel
            .or(() -> frustum)
            .orElseGet(
                () -> {
                  double x = half * Math.max(1, aspect);
                  double y = half * Math.max(1, 1 / aspect);
                  return new OrthographicExtent(-x, -y, x, y);
                });
    return new ViewParameters(
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
