package org.selectiverenderer.enricher.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.authoring.placement.Placement;
import org.selectiverenderer.authoring.placement.TransformPose;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * What a drag of a handle makes of the placements of nodes; a value. All are moved and turned
 * together, the last one alone is scaled.
 *
 * @param items the nodes when the drag began, the one selected last at the end; not empty
 */
public record PlacementDrag(List<Item> items) {
  /** Least length of a side in metres. */
  private static final double LEAST = 0.001;

  /** Angle in degrees to which turns snap. */
  public static final double STEP = 15;

  /**
   * A node that is dragged.
   *
   * @param box its box in the scene
   */
  public record Item(Placement placement, ObjectBox box) {}

  /** Copies the list. */
  public PlacementDrag {
    items = List.copyOf(items);
  }

  private Item last() {
    return items.get(items.size() - 1);
  }

  /** The bounds of all nodes in the world. */
  public BoundingBox bounds() {
    return items.stream().map(item -> item.box().bounds()).reduce(BoundingBox::union).orElseThrow();
  }

  /** The point about which they turn: the centre of the bounds. */
  public Vector3d pivot() {
    BoundingBox all = bounds();
    return all.min().add(all.max()).mul(0.5);
  }

  /**
   * Snaps a shift: the lower corner of the bounds to the grid along the axes that are moved, the
   * lower side to the floor where that is near.
   *
   * @param floor height of what is below
   * @param pull distance at which the floor is near
   */
  public Vector3d snapped(Vector3dc shift, SnapGrid grid, OptionalDouble floor, double pull) {
    Vector3d corner = bounds().min();
    Vector3d snapped = new Vector3d(shift);
    for (int k = 0; k < 3; k++) {
      if (Math.abs(shift.get(k)) > 1e-9) {
        double at = corner.get(k);
        double value = grid.nearest(at + shift.get(k)) - at;
        boolean lands =
            k == 1 && floor.isPresent() && Math.abs(at + shift.y() - floor.getAsDouble()) < pull;
        snapped.setComponent(k, lands ? floor.getAsDouble() - at : value);
      }
    }
    return snapped;
  }

  /** Returns the placements moved by a vector of the scene. */
  public List<Placement> moved(Vector3dc shift) {
    List<Placement> now = new ArrayList<>();
    for (Item item : items) {
      Placement of = item.placement();
      Vector3d own = of.parent().invert(new Matrix4d()).transformDirection(new Vector3d(shift));
      now.add(of.with(of.pose().movedBy(own)));
    }
    return now;
  }

  /**
   * Returns the placements turned about the pivot.
   *
   * @param axis 0 for X, 1 for Y, 2 for Z of the scene
   * @param angle in radians
   */
  public List<Placement> turned(int axis, double angle) {
    Vector3d along = new Vector3d().setComponent(axis, 1);
    Vector3d pivot = pivot();
    List<Placement> now = new ArrayList<>();
    for (Item item : items) {
      Placement of = item.placement();
      Quaterniond around =
          new Quaterniond(TransformPose.of(of.parent(), new Vector3d()).rotation());
      Vector3d own = around.conjugate(new Quaterniond()).transform(new Vector3d(along));
      Quaterniond turn = new Quaterniond().fromAxisAngleRad(own, angle);
      Vector3d fixed = of.parent().invert(new Matrix4d()).transformPosition(new Vector3d(pivot));
      now.add(of.with(of.pose().turned(turn, fixed)));
    }
    return now;
  }

  /** Whether the node selected last can be scaled along single axes: those of its own. */
  public boolean scalesByAxis() {
    return Math.abs(last().placement().pose().scaleOrientation().angle()) < 1e-6;
  }

  /** Returns the direction in the scene of an own axis of the node selected last, of length 1. */
  public Vector3d axis(int axis) {
    return last().box().place().getColumn(axis, new Vector3d()).normalize();
  }

  /** Returns the length in the scene of the box of the node selected last along an own axis. */
  public double length(int axis) {
    return size(axis) * last().box().place().getColumn(axis, new Vector3d()).length();
  }

  private double size(int axis) {
    BoundingBox own = last().box().own();
    return own.max().get(axis) - own.min().get(axis);
  }

  /**
   * Returns the placements with the last one scaled along an own axis; its opposite side stays.
   *
   * @param sign -1 for the side at the lesser coordinate, 1 for the other
   * @param length the length wanted in the scene
   */
  public List<Placement> stretched(int axis, int sign, double length) {
    BoundingBox own = last().box().own();
    Vector3d fixed = own.min().add(own.max()).mul(0.5);
    fixed.setComponent(axis, (sign > 0 ? own.min() : own.max()).get(axis));
    double before = length(axis);
    double factor = before > LEAST ? Math.max(LEAST, length) / before : 1;
    return scaled(new Vector3d(1).setComponent(axis, factor), fixed);
  }

  /** Returns the placements with the last one scaled alike along all axes; its foot stays. */
  public List<Placement> enlarged(double factor) {
    return scaled(new Vector3d(Math.max(LEAST, factor)), foot());
  }

  /** The middle of the own box's side that is lowest in the scene, in own coordinates. */
  private Vector3d foot() {
    BoundingBox own = last().box().own();
    Vector3d foot = own.min().add(own.max()).mul(0.5);
    int axis = 0;
    for (int k = 1; k < 3; k++) {
      axis = Math.abs(axis(k).y) > Math.abs(axis(axis).y) ? k : axis;
    }
    Vector3d side = axis(axis).y > 0 ? own.min() : own.max();
    return foot.setComponent(axis, side.get(axis));
  }

  private List<Placement> scaled(Vector3dc factors, Vector3dc fixed) {
    List<Placement> now = new ArrayList<>();
    items.forEach(item -> now.add(item.placement()));
    Placement of = last().placement();
    now.set(now.size() - 1, of.with(of.pose().scaled(factors, fixed)));
    return now;
  }

  /** Returns the boxes of the nodes in other placements. */
  public List<ObjectBox> boxes(List<Placement> now) {
    List<ObjectBox> boxes = new ArrayList<>();
    for (int i = 0; i < items.size(); i++) {
      ObjectBox box = items.get(i).box();
      Matrix4d change = now.get(i).own().mul(items.get(i).placement().own().invert(new Matrix4d()));
      Matrix4d place = change.mul(box.place(), new Matrix4d());
      BoundingBox bounds =
          onlyMoved(change) ? box.bounds().transformed(change) : box.own().transformed(place);
      boxes.add(new ObjectBox(box.element(), box.own(), place, bounds));
    }
    return boxes;
  }

  private static boolean onlyMoved(Matrix4d change) {
    Matrix4d turn = new Matrix4d(change).setTranslation(0, 0, 0);
    return turn.equals(new Matrix4d(), 1e-9);
  }
}
