package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.browser.camera.Camera;

/**
 * A drag of a handle of an area's box: a face moves along its normal; the centre moves over the
 * ground, or vertically where the ground is seen edge-on. A value except for the camera, which
 * nobody changes. Pixels count from the upper left of the picture.
 *
 * @param area the area when the drag began
 * @param handle 0 to 5: the face at the lesser or greater X, Y, Z; 6: the centre
 * @param camera of the picture
 * @param x pixel x at which the drag began
 * @param y pixel y at which the drag began
 */
record AreaHandleDrag(AreaInstance area, int handle, Camera camera, double x, double y) {
  static final int MIDDLE = 6;
  static final int HANDLES = 7;

  /** Least length of a side in metres. */
  private static final double LEAST = 0.05;

  /**
   * Least sine of the angle between line of sight and ground for which a drag follows the ground.
   */
  private static final double GRAZING = 0.2;

  private int axis() {
    return handle / 2;
  }

  private int sign() {
    return handle % 2 == 0 ? -1 : 1;
  }

  /** The world position of a handle of an area. */
  static Vector3d place(AreaInstance area, int handle) {
    Vector3d at = new Vector3d(area.box().centre());
    if (handle != MIDDLE) {
      int axis = handle / 2;
      double half = area.box().size().get(axis) / 2 * (handle % 2 == 0 ? -1 : 1);
      at.fma(half, area.frame().direction(axis));
    }
    return at;
  }

  /** Projects a world point to pixels of the picture; empty if it is behind the viewer. */
  static Optional<Vector2d> inPicture(Vector3dc place, Camera camera) {
    return new PictureRays(camera).project(place);
  }

  /** Returns the box for a pointer position. */
  AreaBox at(double nowX, double nowY, SnapGrid grid) {
    return handle == MIDDLE ? moved(nowX, nowY, grid) : resized(nowX, nowY, grid);
  }

  private AreaBox resized(double nowX, double nowY, SnapGrid grid) {
    Vector3d direction = area.frame().direction(axis());
    Vector3d face = place(area, handle);
    double pulled = rays().along(face, direction, nowX, nowY) - rays().along(face, direction, x, y);
    double size = area.box().size().get(axis());
    double edge = area.frame().turned() ? sign() * size : face.get(axis());
    pulled = grid.nearest(edge + pulled) - edge;
    double grown = Math.max(sign() * pulled, Math.min(LEAST, size) - size);
    Vector3d newSize = new Vector3d(area.box().size()).setComponent(axis(), size + grown);
    Vector3d centre = new Vector3d(area.box().centre()).fma(sign() * grown / 2, direction);
    return new AreaBox(centre, newSize);
  }

  private AreaBox moved(double nowX, double nowY, SnapGrid grid) {
    Vector3d eye = new Vector3d();
    Vector3d sight = rays().sight(x, y, eye);
    Vector3d normal = new Vector3d(0, 1, 0);
    if (Math.abs(sight.y) < GRAZING) {
      normal.set(sight.x, 0, sight.z).normalize();
    }
    Optional<Vector3d> from = rays().onPlane(area.box().centre(), normal, x, y);
    Optional<Vector3d> to = rays().onPlane(area.box().centre(), normal, nowX, nowY);
    if (from.isEmpty() || to.isEmpty()) {
      return area.box();
    }
    Vector3d shift = to.get().sub(from.get());
    if (!area.frame().turned()) {
      Vector3d corner = area.box().bounds().min();
      for (int k = 0; k < 3; k++) {
        if (Math.abs(shift.get(k)) > 1e-9) {
          shift.setComponent(k, grid.nearest(corner.get(k) + shift.get(k)) - corner.get(k));
        }
      }
    }
    return area.box().movedBy(shift);
  }

  private PictureRays rays() {
    return new PictureRays(camera);
  }
}
