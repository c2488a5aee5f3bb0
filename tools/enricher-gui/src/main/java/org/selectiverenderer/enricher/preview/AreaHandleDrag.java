package org.selectiverenderer.enricher.preview;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.joml.Vector4d;
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
    Vector4d point = new Vector4d(place, 1);
    camera.projection().transform(camera.view().transform(point));
    return point.w > 0
        ? Optional.of(
            new Vector2d(
                (point.x / point.w + 1) / 2 * camera.width(),
                (1 - point.y / point.w) / 2 * camera.height()))
        : Optional.empty();
  }

  /** Returns the box for a pointer position. */
  AreaBox at(double nowX, double nowY, SnapGrid grid) {
    return handle == MIDDLE ? moved(nowX, nowY, grid) : resized(nowX, nowY, grid);
  }

  private AreaBox resized(double nowX, double nowY, SnapGrid grid) {
    Vector3d direction = area.frame().direction(axis());
    Vector3d face = place(area, handle);
    double pulled = along(face, direction, nowX, nowY) - along(face, direction, x, y);
    double size = area.box().size().get(axis());
    double edge = area.frame().turned() ? sign() * size : face.get(axis());
    pulled = grid.nearest(edge + pulled) - edge;
    double grown = Math.max(sign() * pulled, Math.min(LEAST, size) - size);
    Vector3d newSize = new Vector3d(area.box().size()).setComponent(axis(), size + grown);
    Vector3d centre = new Vector3d(area.box().centre()).fma(sign() * grown / 2, direction);
    return new AreaBox(centre, newSize);
  }

  /**
   * Returns the parameter along a line at which the pointer's line of sight comes nearest to it.
   */
  private double along(Vector3dc origin, Vector3dc direction, double px, double py) {
    Vector3d eye = new Vector3d();
    Vector3d sight = sight(px, py, eye);
    Vector3d between = eye.sub(origin, new Vector3d());
    double both = direction.dot(sight);
    double across = 1 - both * both;
    if (across < 1e-4) {
      return 0; // the line of sight is parallel to the line
    }
    return (between.dot(direction) - both * between.dot(sight)) / across;
  }

  private AreaBox moved(double nowX, double nowY, SnapGrid grid) {
    Vector3d eye = new Vector3d();
    Vector3d sight = sight(x, y, eye);
    Vector3d normal = new Vector3d(0, 1, 0);
    if (Math.abs(sight.y) < GRAZING) {
      normal.set(sight.x, 0, sight.z).normalize();
    }
    Optional<Vector3d> from = onPlane(normal, x, y);
    Optional<Vector3d> to = onPlane(normal, nowX, nowY);
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

  private Optional<Vector3d> onPlane(Vector3dc normal, double px, double py) {
    Vector3d eye = new Vector3d();
    Vector3d sight = sight(px, py, eye);
    double towards = sight.dot(normal);
    if (Math.abs(towards) < 1e-3) {
      return Optional.empty();
    }
    double distance = area.box().centre().sub(eye, new Vector3d()).dot(normal) / towards;
    return distance > 0 ? Optional.of(eye.fma(distance, sight)) : Optional.empty();
  }

  /** Returns the unit direction of the line of sight through a pixel, and sets its origin. */
  private Vector3d sight(double px, double py, Vector3d origin) {
    Matrix4dc inverse = camera.projection().mul(camera.view(), new Matrix4d()).invert();
    double right = 2 * px / camera.width() - 1;
    double up = 1 - 2 * py / camera.height();
    Vector4d near = inverse.transform(new Vector4d(right, up, -1, 1));
    Vector4d far = inverse.transform(new Vector4d(right, up, 1, 1));
    origin.set(near.x, near.y, near.z).div(near.w);
    return new Vector3d(far.x, far.y, far.z).div(far.w).sub(origin).normalize();
  }
}
