package org.selectiverenderer.browser.nodes.layout;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * The view parameters of a layer: view matrix, view volume and size of the picture in pixels.
 * Lengths are in world units. Immutable.
 *
 * @param view the view matrix: from the world to the viewer's frame, looking along -Z; not to be
 *     changed
 * @param parallel whether the projection is orthographic
 * @param left the left edge of the view volume in the viewer's frame; in a perspective view, at
 *     distance 1
 * @param right the right edge of the view volume
 * @param bottom the bottom edge of the view volume
 * @param top the top edge of the view volume
 * @param pixelsWide the width of the picture in desktop pixels
 * @param pixelsHigh the height of the picture in desktop pixels
 */
public record ViewParameters(
    Matrix4dc view,
    boolean parallel,
    double left,
    double right,
    double bottom,
    double top,
    double pixelsWide,
    double pixelsHigh) {

  /**
   * Distance from the viewer at which outermost layout rectangles are placed in a perspective view.
   */
  private static final double NEAR_PLANE = 1;

  /**
   * The same distance in an orthographic view, where sizes do not depend on it: enough for some
   * depth on either side.
   */
  private static final double FLAT_PLANE = 10;

  /** The parameters before anything is drawn: a picture of one pixel. */
  public static final ViewParameters NONE =
      new ViewParameters(new Matrix4d(), false, -1, 1, -1, 1, 1, 1);

  /**
   * Returns the pose of the whole picture as a rectangle in the world, in front of the viewer and
   * facing it.
   */
  Matrix4d frame() {
    double depth = parallel ? FLAT_PLANE : NEAR_PLANE;
    double at = parallel ? 1 : depth;
    return view.invertAffine(new Matrix4d())
        .translate((left + right) / 2 * at, (bottom + top) / 2 * at, -depth);
  }

  /** Returns the width of that rectangle. */
  double width() {
    return (right - left) * (parallel ? 1 : NEAR_PLANE);
  }

  /** Returns the height of that rectangle. */
  double height() {
    return (top - bottom) * (parallel ? 1 : NEAR_PLANE);
  }

  /**
   * Returns the height of a pixel at the distance of a place; above 0 also beside and behind the
   * viewer.
   */
  private double pixelAt(Matrix4dc place) {
    Vector3d at = place.getTranslation(new Vector3d());
    double depth = parallel ? 1 : Math.abs(view.transformPosition(at).z);
    return (top - bottom) * Math.max(depth, 1e-9) / pixelsHigh;
  }

  /**
   * Returns the scale for each axis of a place by which one unit becomes as long as a pixel is high
   * there; 1 for an axis without length.
   */
  public Vector3d pixelScale(Matrix4dc place) {
    double pixel = pixelAt(place);
    Vector3d axis = new Vector3d();
    return new Vector3d(
        scale(pixel, place.getColumn(0, axis).length()),
        scale(pixel, place.getColumn(1, axis).length()),
        scale(pixel, place.getColumn(2, axis).length()));
  }

  private static double scale(double wanted, double length) {
    double scale = wanted / length;
    return Double.isFinite(scale) && scale > 0 ? scale : 1;
  }
}
