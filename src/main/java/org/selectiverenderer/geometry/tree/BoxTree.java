package org.selectiverenderer.geometry.tree;

import java.util.function.IntConsumer;
import org.joml.Vector3dc;

/**
 * A bounding-volume hierarchy over numbered items that have axis-aligned boxes. Boxes are kept as
 * floats, rounded outwards, so that it may report an item too many but never one too few. Made by
 * {@link BoxTreeBuilder}.
 */
public final class BoxTree {
  /** The box of an item. */
  @FunctionalInterface
  public interface Boxes {
    /** Writes min x, y, z, max x, y, z, rounded outwards; an empty box has min above max. */
    void box(int item, float[] out);
  }

  /** Decides whether a ray hits an item. */
  @FunctionalInterface
  public interface ItemTest {
    /** Returns the ray parameter of a hit that is nearer than {@code nearest}, else that. */
    double test(int item, double nearest);
  }

  /** Deeper than any tree that the builder makes. */
  public static final int MAX_DEPTH = 96;

  private final Boxes items;
  private final int[] order;
  private final float[] boxes;
  private final int[] first;
  private final int[] count;
  private int[] parent = {};
  private int[] leafOf = {};

  /**
   * @param order the items, those of a leaf side by side
   * @param boxes six numbers per node; node 0 is the root
   * @param first per node: of a leaf where in {@code order} its items begin, else the left child;
   *     the right one follows it
   * @param count per node: the number of items of a leaf, 0 for an inner node
   */
  BoxTree(Boxes items, int[] order, float[] boxes, int[] first, int[] count) {
    this.items = items;
    this.order = order;
    this.boxes = boxes;
    this.first = first;
    this.count = count;
  }

  /** The items, those of a leaf side by side. For reading only, as the arrays below. */
  public int[] order() {
    return order;
  }

  /** Six numbers per node; node 0 is the root. */
  public float[] boxes() {
    return boxes;
  }

  /**
   * Per node: of a leaf where in {@link #order} it begins, else the left child before the right.
   */
  public int[] first() {
    return first;
  }

  /** Per node: the number of items of a leaf, 0 for an inner node. */
  public int[] count() {
    return count;
  }

  /**
   * Tests the items along a ray from near to far.
   *
   * @param limit where the ray ends, in lengths of {@code direction}
   */
  public void ray(Vector3dc origin, Vector3dc direction, double limit, ItemTest test) {
    if (order.length == 0) {
      return;
    }
    RaySlabs slabs = new RaySlabs(origin, direction);
    int[] stack = new int[MAX_DEPTH];
    double[] entered = new double[MAX_DEPTH];
    int size = 0;
    double nearest = limit;
    entered[0] = slabs.enter(boxes, 0, nearest);
    stack[size++] = 0;
    while (size > 0) {
      int node = stack[--size];
      if (!(entered[size] <= nearest)) {
        continue;
      }
      if (count[node] > 0) {
        for (int i = first[node]; i < first[node] + count[node]; i++) {
          nearest = test.test(order[i], nearest);
        }
        continue;
      }
      int near = first[node];
      int far = near + 1;
      double toNear = slabs.enter(boxes, near, nearest);
      double toFar = slabs.enter(boxes, far, nearest);
      if (toFar < toNear) {
        int node2 = near;
        near = far;
        far = node2;
        double swap = toNear;
        toNear = toFar;
        toFar = swap;
      }
      if (toFar <= nearest) {
        entered[size] = toFar;
        stack[size++] = far;
      }
      if (toNear <= nearest) {
        entered[size] = toNear;
        stack[size++] = near;
      }
    }
  }

  /** Names the items in leaves that a box touches: min x, y, z, max x, y, z. */
  public void overlap(double[] box, IntConsumer found) {
    if (order.length == 0) {
      return;
    }
    int[] stack = new int[MAX_DEPTH];
    int size = 1;
    while (size > 0) {
      int node = stack[--size];
      if (!touches(node, box)) {
        continue;
      }
      if (count[node] == 0) {
        stack[size++] = first[node] + 1;
        stack[size++] = first[node];
        continue;
      }
      for (int i = first[node]; i < first[node] + count[node]; i++) {
        found.accept(order[i]);
      }
    }
  }

  private boolean touches(int node, double[] box) {
    int at = 6 * node;
    for (int axis = 0; axis < 3; axis++) {
      if (boxes[at + axis] > box[axis + 3] || boxes[at + axis + 3] < box[axis]) {
        return false;
      }
    }
    return true;
  }

  /** Follows an item whose box is another: the boxes above it are made anew. */
  public void moved(int item) {
    if (leafOf.length == 0) {
      link();
    }
    float[] box = new float[6];
    for (int node = leafOf[item]; node >= 0; node = parent[node]) {
      if (count[node] > 0) {
        enclose(node, box);
      } else {
        int left = 6 * first[node];
        for (int axis = 0; axis < 3; axis++) {
          box[axis] = Math.min(boxes[left + axis], boxes[left + 6 + axis]);
          box[axis + 3] = Math.max(boxes[left + axis + 3], boxes[left + 9 + axis]);
        }
      }
      System.arraycopy(box, 0, boxes, 6 * node, 6);
    }
  }

  private void enclose(int leaf, float[] box) {
    float[] one = new float[6];
    for (int i = 0; i < count[leaf]; i++) {
      items.box(order[first[leaf] + i], one);
      for (int axis = 0; axis < 3; axis++) {
        box[axis] = i == 0 ? one[axis] : Math.min(box[axis], one[axis]);
        box[axis + 3] = i == 0 ? one[axis + 3] : Math.max(box[axis + 3], one[axis + 3]);
      }
    }
  }

  /** Finds every node's parent and every item's leaf: only trees whose items move need them. */
  private void link() {
    parent = new int[count.length];
    parent[0] = -1;
    leafOf = new int[order.length];
    for (int node = 0; node < count.length; node++) {
      if (count[node] == 0) {
        parent[first[node]] = node;
        parent[first[node] + 1] = node;
      } else {
        for (int i = first[node]; i < first[node] + count[node]; i++) {
          leafOf[order[i]] = node;
        }
      }
    }
  }
}
