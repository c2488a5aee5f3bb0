package org.selectiverenderer.radiosity.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.geometry.mesh.EdgeKey;

/**
 * Greedy triangle stripification: in a strip each further triangle takes a single index, so that
 * the text is less than half as long. Every triangle is in one strip with its original winding (X3D
 * 4.0, 11.4.7): the strip a b c d e stands for the triangles a b c, c b d, c d e. From the first
 * triangle left, the longest of the three strips that start at its edges is taken.
 */
final class TriangleStripBuilder {
  private static final int NONE = -1;

  /** The vertices of each triangle, three numbers per triangle. */
  private final int[] corners;

  /**
   * By directed edge: the last corner (three times a triangle plus 0 to 2) at which the edge
   * begins.
   */
  private final Map<Long, Integer> lastAt = new HashMap<>();

  /** Per corner: another corner at which the same edge begins, or {@link #NONE}. */
  private final int[] before;

  private final boolean[] used;

  private TriangleStripBuilder(int[] corners) {
    this.corners = corners;
    before = new int[corners.length];
    used = new boolean[corners.length / 3];
    for (int corner = corners.length - 1; corner >= 0; corner--) {
      Integer last = lastAt.put(EdgeKey.of(corners[corner], corners[next(corner)]), corner);
      before[corner] = last == null ? NONE : last;
    }
  }

  /**
   * @param corners the vertices of each triangle, three numbers per triangle
   * @return the vertices of each strip
   */
  static List<int[]> of(int[] corners) {
    return new TriangleStripBuilder(corners).all();
  }

  private List<int[]> all() {
    List<int[]> all = new ArrayList<>();
    for (int triangle = 0; triangle < used.length; triangle++) {
      if (used[triangle]) {
        continue;
      }
      Walk best = walk(3 * triangle);
      for (int k = 1; k < 3; k++) {
        Walk other = walk(3 * triangle + k);
        best = other.count > best.count ? other : best;
      }
      best.mark(true);
      all.add(Arrays.copyOf(best.vertices, best.count + 2));
    }
    return all;
  }

  private final class Walk {
    int[] vertices = new int[16];
    int[] triangles = new int[16];
    int count;

    void add(int triangle, int vertex) {
      if (count + 3 > vertices.length) {
        vertices = Arrays.copyOf(vertices, 2 * vertices.length);
        triangles = Arrays.copyOf(triangles, 2 * triangles.length);
      }
      triangles[count] = triangle;
      vertices[count + 2] = vertex;
      used[triangle] = true;
      count++;
    }

    void mark(boolean now) {
      for (int i = 0; i < count; i++) {
        used[triangles[i]] = now;
      }
    }
  }

  /**
   * Returns the strip that begins with the triangle of a corner, at that corner; its triangles stay
   * unused.
   */
  private Walk walk(int corner) {
    Walk walk = new Walk();
    walk.vertices[0] = corners[corner];
    walk.vertices[1] = corners[next(corner)];
    walk.add(corner / 3, corners[next(next(corner))]);
    int found = corner;
    while (found != NONE) {
      int a = walk.vertices[walk.count];
      int b = walk.vertices[walk.count + 1];
      // In every other triangle of a strip the first two vertices are swapped.
      found = walk.count % 2 == 1 ? unused(b, a) : unused(a, b);
      if (found != NONE) {
        walk.add(found / 3, corners[next(next(found))]);
      }
    }
    walk.mark(false);
    return walk;
  }

  private int unused(int from, int to) {
    int corner = lastAt.getOrDefault(EdgeKey.of(from, to), NONE);
    while (corner != NONE && used[corner / 3]) {
      corner = before[corner];
    }
    return corner;
  }

  private static int next(int corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
}
