package org.selectiverenderer.geometry.bvh;

import java.util.Arrays;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;

/**
 * Builds a {@link Bvh} top-down. A node is split at the cheapest plane by the surface area
 * heuristic among {@value #BINS} bins along the longest axis of the box centroids (MacDonald and
 * Booth 1990; binned as in Wald 2007), or at the median if there is none. Large parts are built in
 * parallel; the tree is the same.
 */
public final class BvhBuilder {
  private static final int BINS = 12;
  private static final int LEAF = 4;

  /** From this depth on nodes are split at the median, which bounds the depth. */
  private static final int HALVING_DEPTH = 48;

  /** The items of a part above which its halves are built in parallel. */
  private static final int PARALLEL = 16_384;

  private final float[] boxes;
  private final int[] order;
  private final float[] nodeBoxes;
  private final int[] first;
  private final int[] count;
  private int nodes = 1;

  private final float[] centres = new float[6];
  private final float[] binBoxes = new float[6 * BINS];
  private final int[] binCounts = new int[BINS];
  private final float[] rightArea = new float[BINS];

  private BvhBuilder(int size, Bvh.Boxes items) {
    this(new float[6 * size], new int[size], size);
    float[] box = new float[6];
    for (int item = 0; item < size; item++) {
      items.box(item, box);
      System.arraycopy(box, 0, boxes, 6 * item, 6);
      order[item] = item;
    }
  }

  /**
   * Builds a part of a tree.
   *
   * @param size the number of items of the part
   */
  private BvhBuilder(float[] boxes, int[] order, int size) {
    this.boxes = boxes;
    this.order = order;
    int most = Math.max(1, 2 * size);
    nodeBoxes = new float[6 * most];
    first = new int[most];
    count = new int[most];
  }

  /** Builds a tree over the items 0 .. size - 1. */
  public static Bvh build(int size, Bvh.Boxes items) {
    return new BvhBuilder(size, items).build(items);
  }

  /**
   * Reads the boxes of the items 0 .. size - 1 and has a tree over them built by another thread.
   * Items may move meanwhile: {@link Bvh#moved} is to be called for them afterwards.
   */
  public static ForkJoinTask<Bvh> begin(int size, Bvh.Boxes items) {
    BvhBuilder builder = new BvhBuilder(size, items);
    return ForkJoinPool.commonPool().submit(() -> builder.build(items));
  }

  private Bvh build(Bvh.Boxes items) {
    if (order.length > 0) {
      split(0, 0, order.length, 0);
    }
    return new Bvh(
        items,
        order,
        Arrays.copyOf(nodeBoxes, 6 * nodes),
        Arrays.copyOf(first, nodes),
        Arrays.copyOf(count, nodes));
  }

  private void split(int node, int begin, int end, int depth) {
    measure(node, begin, end);
    if (end - begin <= LEAF) {
      first[node] = begin;
      count[node] = end - begin;
      return;
    }
    int axis = longest(centres);
    int cheapest = depth < HALVING_DEPTH ? partition(axis, begin, end) : begin;
    int middle = cheapest == begin || cheapest == end ? halve(axis, begin, end) : cheapest;
    int left = nodes;
    nodes += 2;
    first[node] = left;
    if (end - begin <= PARALLEL) {
      split(left, begin, middle, depth + 1);
      split(left + 1, middle, end, depth + 1);
      return;
    }
    BvhBuilder right = new BvhBuilder(boxes, order, end - middle);
    ForkJoinTask<?> building =
        ForkJoinPool.commonPool().submit(() -> right.split(0, middle, end, depth + 1));
    split(left, begin, middle, depth + 1);
    building.join();
    append(right, left + 1);
  }

  /** Takes over the nodes of a part whose root is a node of this. */
  private void append(BvhBuilder part, int root) {
    int shift = nodes - 1;
    for (int node = 0; node < part.nodes; node++) {
      int to = node == 0 ? root : node + shift;
      System.arraycopy(part.nodeBoxes, 6 * node, nodeBoxes, 6 * to, 6);
      first[to] = part.count[node] > 0 ? part.first[node] : part.first[node] + shift;
      count[to] = part.count[node];
    }
    nodes += part.nodes - 1;
  }

  /** Computes the node's box, and the box of its items' centroids. */
  private void measure(int node, int begin, int end) {
    int at = 6 * node;
    clear(nodeBoxes, at);
    clear(centres, 0);
    for (int i = begin; i < end; i++) {
      grow(nodeBoxes, at, order[i]);
      for (int axis = 0; axis < 3; axis++) {
        float centre = centre(order[i], axis);
        centres[axis] = Math.min(centres[axis], centre);
        centres[axis + 3] = Math.max(centres[axis + 3], centre);
      }
    }
  }

  private static void clear(float[] target, int at) {
    Arrays.fill(target, at, at + 3, Float.POSITIVE_INFINITY);
    Arrays.fill(target, at + 3, at + 6, Float.NEGATIVE_INFINITY);
  }

  private void grow(float[] target, int at, int item) {
    for (int axis = 0; axis < 3; axis++) {
      target[at + axis] = Math.min(target[at + axis], boxes[6 * item + axis]);
      target[at + axis + 3] = Math.max(target[at + axis + 3], boxes[6 * item + axis + 3]);
    }
  }

  /** Returns the centroid of an item's box; 0 for an empty or unbounded one. */
  private float centre(int item, int axis) {
    float centre = 0.5f * boxes[6 * item + axis] + 0.5f * boxes[6 * item + axis + 3];
    return Float.isFinite(centre) ? centre : 0;
  }

  private static int longest(float[] box) {
    float x = box[3] - box[0];
    float y = box[4] - box[1];
    float z = box[5] - box[2];
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  /** Partitions the items at the cheapest plane; returns where the right part begins. */
  private int partition(int axis, int begin, int end) {
    float low = centres[axis];
    float scale = BINS / (centres[axis + 3] - low);
    if (!Float.isFinite(scale)) {
      return begin;
    }
    fillBins(axis, low, scale, begin, end);
    int plane = cheapest();
    int left = begin;
    int right = end;
    while (left < right) {
      if (bin(order[left], axis, low, scale) < plane) {
        left++;
      } else {
        right--;
        int item = order[left];
        order[left] = order[right];
        order[right] = item;
      }
    }
    return left;
  }

  private int bin(int item, int axis, float low, float scale) {
    return Math.min(BINS - 1, (int) ((centre(item, axis) - low) * scale));
  }

  private void fillBins(int axis, float low, float scale, int begin, int end) {
    Arrays.fill(binCounts, 0);
    for (int b = 0; b < BINS; b++) {
      clear(binBoxes, 6 * b);
    }
    for (int i = begin; i < end; i++) {
      int b = bin(order[i], axis, low, scale);
      binCounts[b]++;
      grow(binBoxes, 6 * b, order[i]);
    }
  }

  /** Returns the first bin of the right part for the least sum of area times items. */
  private int cheapest() {
    float[] box = new float[6];
    clear(box, 0);
    for (int b = BINS - 1; b > 0; b--) {
      merge(box, b);
      rightArea[b] = area(box);
    }
    clear(box, 0);
    int total = Arrays.stream(binCounts).sum();
    int leftCount = 0;
    int best = 0;
    float bestCost = Float.POSITIVE_INFINITY;
    for (int plane = 1; plane < BINS; plane++) {
      merge(box, plane - 1);
      leftCount += binCounts[plane - 1];
      float cost = leftCount * area(box) + (total - leftCount) * rightArea[plane];
      if (leftCount > 0 && leftCount < total && cost < bestCost) {
        bestCost = cost;
        best = plane;
      }
    }
    return best;
  }

  private void merge(float[] box, int b) {
    for (int axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis], binBoxes[6 * b + axis]);
      box[axis + 3] = Math.max(box[axis + 3], binBoxes[6 * b + axis + 3]);
    }
  }

  private static float area(float[] box) {
    float x = Math.max(0, box[3] - box[0]);
    float y = Math.max(0, box[4] - box[1]);
    float z = Math.max(0, box[5] - box[2]);
    return x * y + y * z + z * x;
  }

  /** Sorts the items along an axis by their centroids; returns the index of the median. */
  private int halve(int axis, int begin, int end) {
    long[] keys = new long[end - begin];
    for (int i = begin; i < end; i++) {
      int bits = Float.floatToIntBits(centre(order[i], axis));
      long sortable = bits ^ ((bits >> 31) & Integer.MAX_VALUE);
      keys[i - begin] = (sortable << 32) | order[i];
    }
    Arrays.sort(keys);
    for (int i = begin; i < end; i++) {
      order[i] = (int) keys[i - begin];
    }
    return (begin + end) >>> 1;
  }
}
