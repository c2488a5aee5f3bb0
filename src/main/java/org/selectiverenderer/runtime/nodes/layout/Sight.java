package org.selectiverenderer.runtime.nodes.layout;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * What is seen of a layer, and how large that is in a picture. Lengths are the world's. Immutable.
 *
 * @param view from the world to the viewer's frame, looking along -Z; not written to
 * @param parallel whether lines of sight are parallel
 * @param left of what is seen: in a parallel view in the viewer's frame, else at a distance of 1
 * @param right of what is seen
 * @param bottom of what is seen
 * @param top of what is seen
 * @param pixelsWide width of the picture in pixels of the desktop
 * @param pixelsHigh its height
 */
public record Sight(
    Matrix4dc view,
    boolean parallel,
    double left,
    double right,
    double bottom,
    double top,
    double pixelsWide,
    double pixelsHigh) {

  /** Where rectangles lie that belong to no other: in front of what is seen at a near distance. */
  private static final double NEAR_PLANE = 1;

  /** In a parallel view nothing grows by being near: far enough for some depth on either side. */
  private static final double FLAT_PLANE = 10;

  /** A sight before anything is seen: a picture of one pixel. */
  public static final Sight NONE = new Sight(new Matrix4d(), false, -1, 1, -1, 1, 1, 1);

  /** The whole picture as a rectangle in the world, in front of the viewer and facing it. */
  Matrix4d frame() {
    double depth = parallel ? FLAT_PLANE : NEAR_PLANE;
    double at = parallel ? 1 : depth;
    return view.invertAffine(new Matrix4d())
        .translate((left + right) / 2 * at, (bottom + top) / 2 * at, -depth);
  }

  /** Width of that rectangle. */
  double width() {
    return (right - left) * (parallel ? 1 : NEAR_PLANE);
  }

  /** Height of that rectangle. */
  double height() {
    return (top - bottom) * (parallel ? 1 : NEAR_PLANE);
  }

  /** Height of a pixel where something stands; above 0 also beside and behind the viewer. */
  private double pixelAt(Matrix4dc place) {
    Vector3d at = place.getTranslation(new Vector3d());
    double depth = parallel ? 1 : Math.abs(view.transformPosition(at).z);
    return (top - bottom) * Math.max(depth, 1e-9) / pixelsHigh;
  }

  /**
   * By how much the axes of a place are to be scaled that one unit of each is as long as a pixel is
   * high there; 1 for an axis without length.
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
