package org.selectiverenderer.enricher.plan;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.placement.HandleSettings;
import org.selectiverenderer.enricher.placement.PlacementDrag;

/**
 * A handle of the selected objects in the plan; a value.
 *
 * @param kind what it does
 * @param axis the own axis of a side
 * @param sign which side: -1 or 1
 * @param x pixels from the left
 * @param y pixels from the top
 */
record PlanHandle(Kind kind, int axis, int sign, double x, double y) {
  /** Kinds of handles. */
  enum Kind {
    /** Moves over the ground. */
    MOVE,
    /** Moves along X. */
    MOVE_X,
    /** Moves along Z. */
    MOVE_Z,
    /** Turns about the vertical; its place is the centre of a ring. */
    TURN,
    /** Moves a side of the object's own box. */
    SIDE,
    /** Scales alike along all axes. */
    CORNER
  }

  /** Length of the arrows and radius of the ring in pixels. */
  static final double LENGTH = 48;

  private static final double REACH = 7;

  /** Largest sine of the angle between the ground and an axis whose sides can be moved. */
  private static final double LEVEL = 0.3;

  /** Returns the handles of objects. */
  static List<PlanHandle> of(PlacementDrag objects, HandleSettings.Mode mode, PlanTransform scale) {
    Vector3d pivot = objects.pivot();
    double x = scale.toX(pivot.x);
    double y = scale.toY(pivot.z);
    return switch (mode) {
      case MOVE ->
          List.of(
              new PlanHandle(Kind.MOVE, 0, 0, x, y),
              new PlanHandle(Kind.MOVE_X, 0, 0, x + LENGTH, y),
              new PlanHandle(Kind.MOVE_Z, 0, 0, x, y + LENGTH));
      case TURN -> List.of(new PlanHandle(Kind.TURN, 0, 0, x, y));
      case SCALE -> scaling(objects, scale);
    };
  }

  private static List<PlanHandle> scaling(PlacementDrag objects, PlanTransform scale) {
    List<PlanHandle> all = new ArrayList<>();
    ObjectBox box = objects.items().get(objects.items().size() - 1).box();
    Vector3d low = box.own().min();
    Vector3d high = box.own().max();
    for (int k = 0; objects.scalesByAxis() && k < 3; k++) {
      if (Math.abs(objects.axis(k).y) < LEVEL && objects.length(k) > 0) {
        for (int sign = -1; sign <= 1; sign += 2) {
          Vector3d side = new Vector3d(low).add(high).mul(0.5);
          side.setComponent(k, (sign < 0 ? low : high).get(k));
          box.place().transformPosition(side);
          all.add(new PlanHandle(Kind.SIDE, k, sign, scale.toX(side.x), scale.toY(side.z)));
        }
      }
    }
    for (int corner = 0; corner < 8; corner++) {
      Vector3d at = box.place().transformPosition(box.own().corner(corner));
      all.add(new PlanHandle(Kind.CORNER, corner, 0, scale.toX(at.x), scale.toY(at.z)));
    }
    return all;
  }

  /** Whether a position is on it. */
  boolean at(double px, double py) {
    double distance = Math.hypot(px - x, py - y);
    return switch (kind) {
      case TURN -> Math.abs(distance - LENGTH) < REACH;
      case MOVE_X -> Math.abs(py - y) < REACH && px > x - LENGTH + REACH && px < x + 2 * REACH;
      case MOVE_Z -> Math.abs(px - x) < REACH && py > y - LENGTH + REACH && py < y + 2 * REACH;
      default -> distance < REACH;
    };
  }
}
