package org.selectiverenderer.browser.instance;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.ForkJoinTask;
import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntToLongFunction;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;

/**
 * A bounding volume hierarchy over the boxes of all shapes of an {@link InstanceTree}, shown or
 * hidden. It is built at the first search after the structure has changed, or begun before by
 * {@link #begin}, and refitted to shapes that move.
 */
public final class ShapeTree {
  /** The number of moves per shape after which the hierarchy is built anew. */
  private static final int WORN = 4;

  /** The number of shapes above which another thread saves time. */
  private static final int MANY = 4_096;

  private final InstanceTree tree;
  private List<ShapeInstance> shapes = List.of();
  private Bvh boxes = BvhBuilder.build(0, (item, out) -> {});
  private long read;
  private long moves;
  private @Nullable ForkJoinTask<Bvh> building;

  ShapeTree(InstanceTree tree) {
    this.tree = tree;
    read = -1;
  }

  /**
   * Begins to build the hierarchy of the present structure, by another thread; the first search
   * waits for it. Few shapes are left to the first search.
   */
  public void begin() {
    if (shapes != tree.shapes() && tree.shapes().size() >= MANY) {
      read = tree.changes().end();
      shapes = tree.shapes();
      moves = 0;
      building = BvhBuilder.begin(shapes.size(), this::box);
    }
  }

  /**
   * Reports the shapes of all leaves that a test enters.
   *
   * @param found receives indices in {@link InstanceTree#shapes()}, in no particular order
   */
  public void search(Bvh.BoxTest test, IntConsumer found) {
    refresh();
    boxes.search(test, found);
  }

  /**
   * Returns the greatest value of a shape; {@code least} if none is greater.
   *
   * @param bound bounds the value of shapes in a box
   * @param value the value of the shape of an index in {@link InstanceTree#shapes()}
   */
  public double greatest(Bvh.BoxBound bound, IntToDoubleFunction value, double least) {
    refresh();
    return boxes.greatest(bound, value, least);
  }

  /**
   * Returns the indices of all shapes in groups of neighbours.
   *
   * @param weight the weight of the shape of an index
   * @param most the largest weight of a group, if it has more than a few shapes
   */
  public List<int[]> groups(IntToLongFunction weight, long most) {
    refresh();
    return boxes.groups(weight, most);
  }

  private void refresh() {
    if (building != null) {
      boxes = building.join();
      building = null;
    }
    Optional<List<ShapeInstance>> changed = tree.changes().since(read);
    read = tree.changes().end();
    if (shapes != tree.shapes() || changed.isEmpty()) {
      build();
      return;
    }
    for (ShapeInstance shape : changed.get()) {
      boxes.moved(shape.index);
    }
    moves += changed.get().size();
    if (moves > (long) WORN * shapes.size()) {
      build();
    }
  }

  private void build() {
    shapes = tree.shapes();
    moves = 0;
    boxes = BvhBuilder.build(shapes.size(), this::box);
  }

  /** Rounds outwards, so that the box of floats encloses that of doubles. */
  private void box(int item, float[] out) {
    double[] box = shapes.get(item).bounds();
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = Math.nextDown((float) box[axis]);
      out[axis + 3] = Math.nextUp((float) box[axis + 3]);
    }
  }
}
