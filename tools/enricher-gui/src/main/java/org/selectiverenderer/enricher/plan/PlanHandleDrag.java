package org.selectiverenderer.enricher.plan;

import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.placement.PlacementDrag;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * A drag of a handle of the selected objects in the plan; a value.
 *
 * @param objects the objects when the drag began
 * @param handle the handle
 * @param x world X at which the drag began
 * @param z world Z at which the drag began
 */
record PlanHandleDrag(PlacementDrag objects, PlanHandle handle, double x, double z) {
  /** What a drag makes of the objects, and the words beside the mouse. */
  record Dragged(List<Placement> placements, String words) {}

  /**
   * Returns what the objects become for a pointer position.
   *
   * @param snap snaps edges to walls and the grid
   * @param grid the grid for lengths
   * @param free whether nothing snaps
   */
  Dragged at(double nowX, double nowZ, PlanDrag.Snapping snap, SnapGrid grid, boolean free) {
    return switch (handle.kind()) {
      case MOVE, MOVE_X, MOVE_Z -> moved(nowX, nowZ, snap);
      case TURN -> turned(nowX, nowZ, free);
      case SIDE -> stretched(nowX, nowZ, free ? SnapGrid.NONE : grid);
      case CORNER -> enlarged(nowX, nowZ, free);
    };
  }

  private Dragged moved(double nowX, double nowZ, PlanDrag.Snapping snap) {
    BoundingBox before = objects.bounds();
    BoundingBox now = new PlanDrag(before, 0, 0, x, z).at(nowX, nowZ, snap);
    double dx = handle.kind() == PlanHandle.Kind.MOVE_Z ? 0 : now.minX() - before.minX();
    double dz = handle.kind() == PlanHandle.Kind.MOVE_X ? 0 : now.minZ() - before.minZ();
    return new Dragged(
        objects.moved(new Vector3d(dx, 0, dz)),
        Texts.of("placement.shifted", metres(dx), metres(0), metres(dz)));
  }

  private Dragged turned(double nowX, double nowZ, boolean free) {
    Vector3d pivot = objects.pivot();
    // Seen from above, X to the right and Z down, a turn about +Y is counterclockwise.
    double angle =
        Math.atan2(pivot.z - nowZ, nowX - pivot.x) - Math.atan2(pivot.z - z, x - pivot.x);
    angle = Math.IEEEremainder(angle, 2 * Math.PI);
    double step = Math.toRadians(PlacementDrag.STEP);
    double snapped = free ? angle : Math.rint(angle / step) * step;
    return new Dragged(
        objects.turned(1, snapped),
        Texts.of("placement.turned", "Y", DecimalFormatter.rounded(Math.toDegrees(snapped), 1)));
  }

  private Dragged stretched(double nowX, double nowZ, SnapGrid grid) {
    Vector3d direction = objects.axis(handle.axis());
    double level = Math.max(1e-6, direction.x * direction.x + direction.z * direction.z);
    double pulled = ((nowX - x) * direction.x + (nowZ - z) * direction.z) / level;
    double length = grid.nearest(objects.length(handle.axis()) + handle.sign() * pulled);
    double least = grid.step() > 0 ? grid.step() : 0.01;
    length = Math.max(Math.min(least, objects.length(handle.axis())), length);
    return new Dragged(
        objects.stretched(handle.axis(), handle.sign(), length),
        Texts.of("placement.length", metres(length)));
  }

  private Dragged enlarged(double nowX, double nowZ, boolean free) {
    Vector3d pivot = objects.pivot();
    double before = Math.max(1e-6, Math.hypot(x - pivot.x, z - pivot.z));
    double factor = Math.max(0.01, Math.hypot(nowX - pivot.x, nowZ - pivot.z) / before);
    double snapped = free ? factor : Math.max(0.05, Math.rint(factor * 20) / 20);
    return new Dragged(
        objects.enlarged(snapped),
        Texts.of("placement.factor", DecimalFormatter.fixed(snapped, 2)));
  }

  /** The verb of the undo step, a key of the bundle {@code placement}. */
  String verb() {
    return switch (handle.kind()) {
      case MOVE, MOVE_X, MOVE_Z -> "move";
      case TURN -> "turn";
      case SIDE, CORNER -> "scale";
    };
  }

  private static String metres(double value) {
    return DecimalFormatter.fixed(value, 2);
  }
}
