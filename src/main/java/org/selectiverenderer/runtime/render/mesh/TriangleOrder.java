package org.selectiverenderer.runtime.render.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Puts the triangles of a mesh into an order in which neighbours in space stand together, by
 * splitting them at the median of their centres along the longest side again and again.
 */
final class TriangleOrder {
  private final float[] centres;
  private final int[] order;
  private final int most;
  private final List<Integer> ends = new ArrayList<>();

  private TriangleOrder(float[] centres, int count, int most) {
    this.centres = centres;
    this.most = most;
    order = new int[count];
    Arrays.setAll(order, i -> i);
  }

  /**
   * @param triangles triangle numbers in their new order
   * @param ends where in it each cluster ends
   */
  record Result(int[] triangles, int[] ends) {}

  /**
   * @param most the largest number of triangles in a cluster
   */
  static Result of(float[] positions, int[] indices, int most) {
    int count = indices.length / 3;
    float[] centres = new float[3 * count];
    for (int t = 0; t < count; t++) {
      for (int corner = 0; corner < 3; corner++) {
        int v = 3 * indices[3 * t + corner];
        centres[3 * t] += positions[v] / 3;
        centres[3 * t + 1] += positions[v + 1] / 3;
        centres[3 * t + 2] += positions[v + 2] / 3;
      }
    }
    TriangleOrder work = new TriangleOrder(centres, count, most);
    if (count > 0) {
      work.split(0, count);
    }
    return new Result(work.order, work.ends.stream().mapToInt(Integer::intValue).toArray());
  }

  private void split(int from, int to) {
    int count = to - from;
    if (count <= most) {
      // The file's own order within a cluster is usually a good one for the vertex cache.
      Arrays.sort(order, from, to);
      ends.add(to);
      return;
    }
    int axis = longestAxis(from, to);
    int clusters = (count + most - 1) / most;
    int middle = from + clusters / 2 * most;
    select(from, to - 1, middle, axis);
    split(from, middle);
    split(middle, to);
  }

  private int longestAxis(int from, int to) {
    int longest = 0;
    float length = -1;
    for (int axis = 0; axis < 3; axis++) {
      float min = Float.POSITIVE_INFINITY;
      float max = Float.NEGATIVE_INFINITY;
      for (int i = from; i < to; i++) {
        float value = centres[3 * order[i] + axis];
        min = Math.min(min, value);
        max = Math.max(max, value);
      }
      if (max - min > length) {
        length = max - min;
        longest = axis;
      }
    }
    return longest;
  }

  /** Hoare's selection: what stands before {@code wanted} is not above it on that axis. */
  private void select(int from, int to, int wanted, int axis) {
    int low = from;
    int high = to;
    while (low < high) {
      float pivot = centres[3 * order[(low + high) >>> 1] + axis];
      int i = low;
      int j = high;
      while (i <= j) {
        while (centres[3 * order[i] + axis] < pivot) {
          i++;
        }
        while (centres[3 * order[j] + axis] > pivot) {
          j--;
        }
        if (i <= j) {
          int swap = order[i];
          order[i++] = order[j];
          order[j--] = swap;
        }
      }
      if (wanted <= j) {
        high = j;
      } else if (wanted >= i) {
        low = i;
      } else {
        return;
      }
    }
  }
}
