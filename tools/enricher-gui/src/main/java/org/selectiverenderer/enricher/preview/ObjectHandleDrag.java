package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.placement.PlacementDrag;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * A drag of a handle of the selected objects in the picture; a value. Pixels count from the upper
 * left of the picture.
 *
 * @param objects the objects when the drag began
 * @param handle the handle
 * @param rays of the picture
 * @param x pixel x at which the drag began
 * @param y pixel y at which the drag began
 */
record ObjectHandleDrag(
    PlacementDrag objects, ObjectHandle handle, PictureRays rays, double x, double y) {
  private static final String[] AXES = {"X", "Y", "Z"};

  /** Distance in pixels at which the lower side snaps to the floor. */
  private static final double PULL = 8;

  /** Least sine of the angle between line of sight and a ring for which the ring is followed. */
  private static final double GRAZING = 0.15;

  /** What a drag makes of the objects, and the words beside the mouse. */
  record Dragged(List<Placement> placements, String words) {}

  /** Returns what the objects become for a pointer position. */
  Dragged at(double nowX, double nowY, SnapGrid grid, boolean free, OptionalDouble floor) {
    return switch (handle.kind()) {
      case AXIS, PLANE, SURFACE ->
          shifted(objects.snapped(shift(nowX, nowY), grid, free ? none() : floor, pull()));
      case RING -> turned(nowX, nowY, free);
      case FACE -> stretched(nowX, nowY, grid);
      case CORNER -> enlarged(nowX, nowY, free);
    };
  }

  private static OptionalDouble none() {
    return OptionalDouble.empty();
  }

  private double pull() {
    return PULL * rays.pixel(objects.pivot());
  }

  /**
   * Returns what the objects become when they stand on a surface.
   *
   * @param point of the surface under the mouse
   */
  Dragged on(Vector3dc point, SnapGrid grid) {
    BoundingBox bounds = objects.bounds();
    Vector3d foot = objects.pivot();
    foot.y = bounds.minY();
    Vector3d shift = point.sub(foot, new Vector3d());
    double up = shift.y;
    Vector3d snapped = objects.snapped(shift, grid, none(), 0);
    snapped.y = up;
    return shifted(snapped);
  }

  private Dragged shifted(Vector3d shift) {
    return new Dragged(
        objects.moved(shift),
        Texts.of("placement.shifted", metres(shift.x), metres(shift.y), metres(shift.z)));
  }

  private Vector3d shift(double nowX, double nowY) {
    Vector3d pivot = objects.pivot();
    if (handle.kind() == ObjectHandle.Kind.AXIS) {
      Vector3d along = new Vector3d().setComponent(handle.axis(), 1);
      return along.mul(rays.along(pivot, along, nowX, nowY) - rays.along(pivot, along, x, y));
    }
    int axis = handle.kind() == ObjectHandle.Kind.SURFACE ? 1 : handle.axis();
    Vector3d normal = new Vector3d().setComponent(axis, 1);
    Optional<Vector3d> from = rays.onPlane(pivot, normal, x, y);
    Optional<Vector3d> to = rays.onPlane(pivot, normal, nowX, nowY);
    return from.isPresent() && to.isPresent()
        ? to.get().sub(from.get()).setComponent(axis, 0)
        : new Vector3d();
  }

  private Dragged turned(double nowX, double nowY, boolean free) {
    double angle = angle(nowX, nowY);
    double step = Math.toRadians(PlacementDrag.STEP);
    double snapped = free ? angle : Math.rint(angle / step) * step;
    return new Dragged(
        objects.turned(handle.axis(), snapped),
        Texts.of(
            "placement.turned",
            AXES[handle.axis()],
            DecimalFormatter.rounded(Math.toDegrees(snapped), 1)));
  }

  /** Returns the angle about the handle's axis between the drag's begin and a pointer position. */
  private double angle(double nowX, double nowY) {
    Vector3d pivot = objects.pivot();
    Vector3d axis = new Vector3d().setComponent(handle.axis(), 1);
    Vector3d eye = new Vector3d();
    double towards = rays.sight(x, y, eye).dot(axis);
    Optional<Vector3d> from = rays.onPlane(pivot, axis, x, y);
    Optional<Vector3d> to = rays.onPlane(pivot, axis, nowX, nowY);
    if (Math.abs(towards) > GRAZING && from.isPresent() && to.isPresent()) {
      Vector3d one = from.get().sub(pivot);
      Vector3d other = to.get().sub(pivot);
      return Math.atan2(one.cross(other, new Vector3d()).dot(axis), one.dot(other));
    }
    // Seen from its edge, the ring turns by the way along it on the screen.
    Vector2d centre = rays.project(pivot).orElse(new Vector2d(x, y));
    Vector2d tip = rays.project(new Vector3d(axis).mul(pull()).add(pivot)).orElse(centre);
    Vector2d across = new Vector2d(tip).sub(centre);
    double length = Math.max(1e-9, across.length());
    double way = ((nowX - x) * across.y - (nowY - y) * across.x) / length;
    return -way / 80;
  }

  private Dragged stretched(double nowX, double nowY, SnapGrid grid) {
    int axis = handle.axis();
    Vector3d direction = objects.axis(axis);
    PlacementDrag.Item last = objects.items().get(objects.items().size() - 1);
    BoundingBox own = last.box().own();
    Vector3d face = last.box().place().transformPosition(own.min().add(own.max()).mul(0.5));
    double pulled = rays.along(face, direction, nowX, nowY) - rays.along(face, direction, x, y);
    double length = grid.nearest(objects.length(axis) + handle.sign() * pulled);
    if (length <= 0) {
      length = Math.min(objects.length(axis), grid.step() > 0 ? grid.step() : 0.01);
    }
    return new Dragged(
        objects.stretched(axis, handle.sign(), length),
        Texts.of("placement.length", metres(length)));
  }

  private Dragged enlarged(double nowX, double nowY, boolean free) {
    Vector2d centre = rays.project(objects.pivot()).orElse(new Vector2d());
    double before = Math.max(1, centre.distance(x, y));
    double factor = Math.max(0.01, centre.distance(nowX, nowY) / before);
    double snapped = free ? factor : Math.max(0.05, Math.rint(factor * 20) / 20);
    return new Dragged(
        objects.enlarged(snapped),
        Texts.of("placement.factor", DecimalFormatter.fixed(snapped, 2)));
  }

  /** The verb of the undo step, a key of the bundle {@code placement}. */
  String verb() {
    return switch (handle.kind()) {
      case AXIS, PLANE, SURFACE -> "move";
      case RING -> "turn";
      case FACE, CORNER -> "scale";
    };
  }

  private static String metres(double value) {
    return DecimalFormatter.fixed(value, 2);
  }
}
