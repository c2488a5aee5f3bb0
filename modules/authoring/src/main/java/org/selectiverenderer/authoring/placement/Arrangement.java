package org.selectiverenderer.authoring.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.BoundingBox;

/** Computes how far boxes have to move to be aligned or distributed, in scene coordinates. */
public final class Arrangement {
  /** The part of the boxes that is aligned. */
  public enum Side {
    LOWER,
    MIDDLE,
    UPPER
  }

  private Arrangement() {}

  /**
   * Returns the shift of each box that brings one side of all to that side of their union.
   *
   * @param axis 0 for X, 1 for Y, 2 for Z
   */
  public static List<Vector3d> align(List<BoundingBox> boxes, int axis, Side side) {
    BoundingBox all = boxes.stream().reduce(BoundingBox.EMPTY, BoundingBox::union);
    double wanted = at(all, axis, side);
    return boxes.stream()
        .map(box -> new Vector3d().setComponent(axis, wanted - at(box, axis, side)))
        .toList();
  }

  private static double at(BoundingBox box, int axis, Side side) {
    double low = box.min().get(axis);
    double high = box.max().get(axis);
    return switch (side) {
      case LOWER -> low;
      case MIDDLE -> (low + high) / 2;
      case UPPER -> high;
    };
  }

  /**
   * Returns the shift of each box that makes the gaps between them equal; the first and the last
   * along the axis stay.
   */
  public static List<Vector3d> distribute(List<BoundingBox> boxes, int axis) {
    List<Integer> order =
        IntStream.range(0, boxes.size())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> at(boxes.get(i), axis, Side.MIDDLE)))
            .toList();
    List<Vector3d> shifts = new ArrayList<>();
    boxes.forEach(box -> shifts.add(new Vector3d()));
    if (boxes.size() < 3) {
      return shifts;
    }
    BoundingBox first = boxes.get(order.get(0));
    BoundingBox last = boxes.get(order.get(order.size() - 1));
    double free = at(last, axis, Side.LOWER) - at(first, axis, Side.UPPER);
    for (int i : order.subList(1, order.size() - 1)) {
      free -= length(boxes.get(i), axis);
    }
    double gap = free / (boxes.size() - 1);
    double at = at(first, axis, Side.UPPER) + gap;
    for (int i : order.subList(1, order.size() - 1)) {
      shifts.get(i).setComponent(axis, at - at(boxes.get(i), axis, Side.LOWER));
      at += length(boxes.get(i), axis) + gap;
    }
    return shifts;
  }

  private static double length(BoundingBox box, int axis) {
    return at(box, axis, Side.UPPER) - at(box, axis, Side.LOWER);
  }
}
