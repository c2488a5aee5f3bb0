package org.selectiverenderer.geometry.bvh;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import org.joml.Vector3dc;

/**
 * A bounding volume hierarchy (BVH) over numbered items with axis-aligned boxes. Boxes are stored
 * as floats rounded outwards, so that queries are conservative: they may report an item too many
 * but never miss one. Built by {@link BvhBuilder}.
 */
public final class Bvh {
  /** Provides the boxes of the items. */
  @FunctionalInterface
  public interface Boxes {
    /** Writes min x, y, z, max x, y, z, rounded outwards; in an empty box min is above max. */
    void box(int item, float[] out);
  }

  /** Tests whether a ray hits an item. */
  @FunctionalInterface
  public interface ItemTest {
    /** Returns the ray parameter of a hit that is nearer than {@code nearest}, else that. */
    double test(int item, double nearest);
  }

  /** Tests whether a search enters a node. */
  @FunctionalInterface
  public interface BoxTest {
    /**
     * @param boxes holds min x, y, z, max x, y, z of the node
     * @param at the index of min x
     * @param leaf whether the node's items are reported if it is entered
     */
    boolean enters(float[] boxes, int at, boolean leaf);
  }

  /** A depth greater than that of any tree of the builder. */
  public static final int MAX_DEPTH = 96;

  private final Boxes items;
  private final int[] order;
  private final float[] boxes;
  private final int[] first;
  private final int[] count;
  private int[] parent = {};
  private int[] leafOf = {};

  /**
   * Creates a tree from its arrays.
   *
   * @param order the items, those of a leaf consecutive
   * @param boxes six numbers per node; node 0 is the root
   * @param first for a leaf the index in {@code order} of its first item, for an inner node its
   *     left child, which the right child follows
   * @param count for a leaf the number of its items, 0 for an inner node
   */
  Bvh(Boxes items, int[] order, float[] boxes, int[] first, int[] count) {
    this.items = items;
    this.order = order;
    this.boxes = boxes;
    this.first = first;
    this.count = count;
  }

  /** Returns the items, those of a leaf consecutive; not to be modified, as the arrays below. */
  public int[] order() {
    return order;
  }

  /** Returns six numbers per node; node 0 is the root. */
  public float[] boxes() {
    return boxes;
  }

  /**
   * Returns for a leaf the index in {@link #order} of its first item, for an inner node its left
   * child, which the right child follows.
   */
  public int[] first() {
    return first;
  }

  /** Returns for a leaf the number of its items, 0 for an inner node. */
  public int[] count() {
    return count;
  }

  /**
   * Tests the items along a ray from front to back.
   *
   * @param limit the ray parameter at which the ray ends, in lengths of {@code direction}
   */
  public void ray(Vector3dc origin, Vector3dc direction, double limit, ItemTest test) {
    if (order.length == 0) {
      return;
    }
    RaySlabIntersection slabs = new RaySlabIntersection(origin, direction);
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

  /** Bounds a value of the items in a box. */
  @FunctionalInterface
  public interface BoxBound {
    /**
     * Returns a number that no item in the box has more of.
     *
     * @param boxes holds min x, y, z, max x, y, z of the node
     * @param at the index of min x
     */
    double most(float[] boxes, int at);
  }

  /**
   * Returns the greatest value of an item (branch and bound); {@code least} if none is greater.
   *
   * @param value the value of an item
   */
  public double greatest(BoxBound bound, IntToDoubleFunction value, double least) {
    return order.length == 0 ? least : greatest(0, bound, value, least);
  }

  private double greatest(int node, BoxBound bound, IntToDoubleFunction value, double least) {
    double best = least;
    if (count[node] > 0) {
      for (int i = 0; i < count[node]; i++) {
        best = Math.max(best, value.applyAsDouble(order[first[node] + i]));
      }
      return best;
    }
    int left = first[node];
    double ofLeft = bound.most(boxes, 6 * left);
    double ofRight = bound.most(boxes, 6 * (left + 1));
    int other = ofLeft >= ofRight ? left + 1 : left;
    if (!(Math.max(ofLeft, ofRight) <= best)) {
      best = greatest(other == left ? left + 1 : left, bound, value, best);
    }
    if (!(Math.min(ofLeft, ofRight) <= best)) {
      best = greatest(other, bound, value, best);
    }
    return best;
  }

  /** Reports the items of all leaves that overlap a box (min x, y, z, max x, y, z). */
  public void overlap(double[] box, IntConsumer found) {
    search((of, at, leaf) -> touches(of, at, box), found);
  }

  /** Reports the items of all leaves that a test enters, as it does all nodes above them. */
  public void search(BoxTest test, IntConsumer found) {
    if (order.length == 0) {
      return;
    }
    int[] stack = new int[MAX_DEPTH];
    int size = 1;
    while (size > 0) {
      int node = stack[--size];
      if (!test.enters(boxes, 6 * node, count[node] > 0)) {
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

  /**
   * Returns the items in groups of neighbours, each item in one of them: the largest subtrees that
   * are light enough, and leaves.
   *
   * @param weight the weight of each item
   * @param most the largest weight of a group of several leaves
   */
  public List<int[]> groups(IntToLongFunction weight, long most) {
    List<int[]> groups = new ArrayList<>();
    if (order.length > 0) {
      long[] weights = new long[count.length];
      weigh(0, weight, weights);
      group(0, weights, most, groups);
    }
    return groups;
  }

  private long weigh(int node, IntToLongFunction weight, long[] weights) {
    long sum = 0;
    for (int i = 0; i < count[node]; i++) {
      sum += weight.applyAsLong(order[first[node] + i]);
    }
    if (count[node] == 0) {
      sum = weigh(first[node], weight, weights) + weigh(first[node] + 1, weight, weights);
    }
    weights[node] = sum;
    return sum;
  }

  private void group(int node, long[] weights, long most, List<int[]> groups) {
    if (count[node] > 0 || weights[node] <= most) {
      IntStream.Builder items = IntStream.builder();
      collect(node, items);
      groups.add(items.build().toArray());
    } else {
      group(first[node], weights, most, groups);
      group(first[node] + 1, weights, most, groups);
    }
  }

  private void collect(int node, IntStream.Builder to) {
    for (int i = 0; i < count[node]; i++) {
      to.add(order[first[node] + i]);
    }
    if (count[node] == 0) {
      collect(first[node], to);
      collect(first[node] + 1, to);
    }
  }

  private static boolean touches(float[] boxes, int at, double[] box) {
    for (int axis = 0; axis < 3; axis++) {
      if (boxes[at + axis] > box[axis + 3] || boxes[at + axis + 3] < box[axis]) {
        return false;
      }
    }
    return true;
  }

  /** Refits the boxes of all nodes above an item whose box has changed. */
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

  /** Computes every node's parent and every item's leaf, which only refitting needs. */
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

  /** A ray prepared for slab tests against many axis-aligned boxes (Kay and Kajiya 1986). */
  private static final class RaySlabIntersection {
    /** Enlarges the exit parameter by the rounding error of its two operations (Ize 2013). */
    private static final double SLACK = 1 + 4 * Math.ulp(1.0);

    private final double[] origin;
    private final double[] inverse;

    RaySlabIntersection(Vector3dc origin, Vector3dc direction) {
      this.origin = new double[] {origin.x(), origin.y(), origin.z()};
      this.inverse = new double[] {1 / direction.x(), 1 / direction.y(), 1 / direction.z()};
    }

    /**
     * Returns the ray parameter at which the ray enters a box, in lengths of its direction, at
     * least 0; NaN if it misses the box or enters it beyond {@code limit}, so that comparisons are
     * false.
     */
    double enter(float[] boxes, int box, double limit) {
      double from = 0;
      double to = limit;
      int at = 6 * box;
      for (int axis = 0; axis < 3; axis++) {
        double low = boxes[at + axis] - origin[axis];
        double high = boxes[at + axis + 3] - origin[axis];
        if (low > high) {
          return Double.NaN;
        }
        if (Double.isInfinite(inverse[axis])) {
          // parallel to the slab: entirely inside or entirely outside
          if (low > 0 || high < 0) {
            return Double.NaN;
          }
          continue;
        }
        double a = low * inverse[axis];
        double b = high * inverse[axis];
        from = Math.max(from, Math.min(a, b));
        to = Math.min(to, Math.max(a, b) * SLACK);
      }
      return from <= to ? from : Double.NaN;
    }
  }
}
