package org.selectiverenderer.render.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Divides the triangles of a mesh into clusters of neighbours by recursive median splits of their
 * centres along the longest axis.
 */
final class TriangleClusterer {
  private final float[] centres;
  private final int[] order;
  private final int most;
  private final List<Integer> ends = new ArrayList<>();

  private TriangleClusterer(float[] centres, int count, int most) {
    this.centres = centres;
    this.most = most;
    order = new int[count];
    Arrays.setAll(order, i -> i);
  }

  /**
   * @param triangles triangle numbers, sorted by cluster
   * @param ends the end of each cluster in that order
   */
  record Result(int[] triangles, int[] ends) {}

  /**
   * @param most the most triangles in a cluster
   */
  static Result of(float[] positions, int[] indices, int most) {
    int count = indices.length / 3;
    // A mesh that is one cluster keeps its order.
    float[] centres = count <= most ? new float[0] : centres(positions, indices);
    TriangleClusterer work = new TriangleClusterer(centres, count, most);
    if (count > 0) {
      work.split(0, count);
    }
    return new Result(work.order, work.ends.stream().mapToInt(Integer::intValue).toArray());
  }

  private static float[] centres(float[] positions, int[] indices) {
    float[] centres = new float[indices.length];
    for (int i = 0; i < indices.length; i += 3) {
      int a = 3 * indices[i];
      int b = 3 * indices[i + 1];
      int c = 3 * indices[i + 2];
      for (int axis = 0; axis < 3; axis++) {
        centres[i + axis] =
            positions[a + axis] / 3 + positions[b + axis] / 3 + positions[c + axis] / 3;
      }
    }
    return centres;
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
    int first = 3 * order[from];
    float minX = centres[first];
    float minY = centres[first + 1];
    float minZ = centres[first + 2];
    float maxX = minX;
    float maxY = minY;
    float maxZ = minZ;
    for (int i = from + 1; i < to; i++) {
      int at = 3 * order[i];
      float x = centres[at];
      float y = centres[at + 1];
      float z = centres[at + 2];
      minX = x < minX ? x : minX;
      maxX = x > maxX ? x : maxX;
      minY = y < minY ? y : minY;
      maxY = y > maxY ? y : maxY;
      minZ = z < minZ ? z : minZ;
      maxZ = z > maxZ ? z : maxZ;
    }
    int longest = maxY - minY > maxX - minX ? 1 : 0;
    return maxZ - minZ > (longest == 1 ? maxY - minY : maxX - minX) ? 2 : longest;
  }

  /**
   * Partially sorts by Hoare's selection algorithm: no centre before {@code wanted} is greater on
   * that axis.
   */
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
