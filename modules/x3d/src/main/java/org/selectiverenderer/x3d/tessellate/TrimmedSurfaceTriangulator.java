package org.selectiverenderer.x3d.tessellate;

import earcut4j.Earcut;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Triangulates the trimmed parameter domain of a surface: the interior of the trimming loops is
 * triangulated, and each triangle is clipped to the cells of a regular grid. By the even-odd rule,
 * a loop inside another is a hole, and one inside a hole is an island.
 */
final class TrimmedSurfaceTriangulator {
  /** Creates the vertex at u and v and returns its index. */
  @FunctionalInterface
  interface Vertices {
    int at(double u, double v);
  }

  /** Receives triangles as three vertex indices, counter-clockwise in u and v. */
  @FunctionalInterface
  interface Triangles {
    void add(int a, int b, int c);
  }

  private record Place(double u, double v) {}

  private final double[] us;
  private final double[] vs;
  private final Map<Place, Integer> known = new HashMap<>();

  /**
   * Creates a grid.
   *
   * @param us the ascending grid parameters in u
   * @param vs the ascending grid parameters in v
   */
  TrimmedSurfaceTriangulator(double[] us, double[] vs) {
    this.us = us;
    this.vs = vs;
  }

  /**
   * Triangulates the domain inside the contours.
   *
   * @param contours u, v per point; without any, the domain is the whole surface
   */
  void fill(List<double[]> contours, Vertices vertices, Triangles triangles) {
    List<double[]> all = new ArrayList<>();
    contours.forEach(contour -> all.add(inDomain(contour)));
    if (all.isEmpty()) {
      double u = us[us.length - 1];
      double v = vs[vs.length - 1];
      all.add(new double[] {us[0], vs[0], u, vs[0], u, v, us[0], v});
    }
    for (double[] outer : all) {
      if (depth(outer, all) % 2 == 0) {
        region(outer, all, vertices, triangles);
      }
    }
  }

  private double[] inDomain(double[] contour) {
    double[] inside = contour.clone();
    for (int i = 0; i < inside.length; i += 2) {
      inside[i] = Math.max(us[0], Math.min(inside[i], us[us.length - 1]));
      inside[i + 1] = Math.max(vs[0], Math.min(inside[i + 1], vs[vs.length - 1]));
    }
    return inside;
  }

  private static int depth(double[] contour, List<double[]> all) {
    int depth = 0;
    for (double[] other : all) {
      if (other != contour && holds(other, contour)) {
        depth++;
      }
    }
    return depth;
  }

  /** Returns whether most points of the second polygon lie in the first; contours may touch. */
  private static boolean holds(double[] polygon, double[] other) {
    int inside = 0;
    for (int i = 0; i < other.length; i += 2) {
      inside += inside(polygon, other[i], other[i + 1]) ? 1 : 0;
    }
    return 4 * inside > other.length;
  }

  private static boolean inside(double[] polygon, double x, double y) {
    boolean inside = false;
    for (int i = 0, j = polygon.length - 2; i < polygon.length; j = i, i += 2) {
      if (polygon[i + 1] > y != polygon[j + 1] > y) {
        double cross =
            (polygon[j] - polygon[i]) * (y - polygon[i + 1]) / (polygon[j + 1] - polygon[i + 1])
                + polygon[i];
        inside ^= x < cross;
      }
    }
    return inside;
  }

  private void region(double[] outer, List<double[]> all, Vertices vertices, Triangles triangles) {
    int depth = depth(outer, all);
    List<double[]> rings = new ArrayList<>(List.of(outer));
    for (double[] hole : all) {
      if (hole != outer && holds(outer, hole) && depth(hole, all) == depth + 1) {
        rings.add(hole);
      }
    }
    int[] holes = new int[rings.size() - 1];
    double[] plane = new double[rings.stream().mapToInt(ring -> ring.length).sum()];
    int at = 0;
    for (int ring = 0; ring < rings.size(); ring++) {
      if (ring > 0) {
        holes[ring - 1] = at / 2;
      }
      System.arraycopy(rings.get(ring), 0, plane, at, rings.get(ring).length);
      at += rings.get(ring).length;
    }
    List<Integer> parts = Earcut.earcut(plane, holes, 2);
    for (int i = 0; i + 2 < parts.size(); i += 3) {
      double[] triangle = new double[6];
      for (int corner = 0; corner < 3; corner++) {
        triangle[2 * corner] = plane[2 * parts.get(i + corner)];
        triangle[2 * corner + 1] = plane[2 * parts.get(i + corner) + 1];
      }
      divide(triangle, vertices, triangles);
    }
  }

  /** Clips a triangle to the columns of the grid, and these to its cells. */
  private void divide(double[] triangle, Vertices vertices, Triangles triangles) {
    double[] range = range(triangle, 0);
    int firstColumn = cell(us, range[0]);
    int lastColumn = cell(us, range[1]);
    for (int column = firstColumn; column <= lastColumn; column++) {
      double[] strip = strip(triangle, 0, us, column);
      if (strip.length < 6) {
        continue;
      }
      double[] high = range(strip, 1);
      int lastRow = cell(vs, high[1]);
      for (int row = cell(vs, high[0]); row <= lastRow; row++) {
        fan(strip(strip, 1, vs, row), vertices, triangles);
      }
    }
  }

  private static double[] range(double[] polygon, int axis) {
    double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int i = axis; i < polygon.length; i += 2) {
      range[0] = Math.min(range[0], polygon[i]);
      range[1] = Math.max(range[1], polygon[i]);
    }
    return range;
  }

  /** Returns the cell that contains a value. */
  private static int cell(double[] lines, double value) {
    int found = Arrays.binarySearch(lines, value);
    int cell = found >= 0 ? found : -found - 2;
    return Math.max(0, Math.min(cell, lines.length - 2));
  }

  private static double[] strip(double[] polygon, int axis, double[] lines, int cell) {
    return cut(cut(polygon, axis, lines[cell], 1), axis, lines[cell + 1], -1);
  }

  /** Clips a convex polygon to one side of a grid line (Sutherland-Hodgman). */
  private static double[] cut(double[] polygon, int axis, double line, int side) {
    double[] out = new double[2 * polygon.length + 4];
    int count = 0;
    for (int i = 0, j = polygon.length - 2; i < polygon.length; j = i, i += 2) {
      double before = side * (polygon[j + axis] - line);
      double now = side * (polygon[i + axis] - line);
      if (before < 0 != now < 0 && before != 0 && now != 0) {
        double part = before / (before - now);
        int other = 1 - axis;
        out[count + axis] = line;
        out[count + other] = polygon[j + other] + part * (polygon[i + other] - polygon[j + other]);
        count += 2;
      }
      if (now >= 0) {
        out[count++] = polygon[i];
        out[count++] = polygon[i + 1];
      }
    }
    return Arrays.copyOf(out, count);
  }

  private void fan(double[] polygon, Vertices vertices, Triangles triangles) {
    double area = 0;
    for (int i = 0, j = polygon.length - 2; i < polygon.length; j = i, i += 2) {
      area += polygon[j] * polygon[i + 1] - polygon[i] * polygon[j + 1];
    }
    if (polygon.length < 6 || area == 0) {
      return;
    }
    int[] corners = new int[polygon.length / 2];
    for (int i = 0; i < corners.length; i++) {
      Place place = new Place(polygon[2 * i], polygon[2 * i + 1]);
      corners[i] = known.computeIfAbsent(place, p -> vertices.at(p.u, p.v));
    }
    for (int i = 2; i < corners.length; i++) {
      triangles.add(corners[0], corners[area > 0 ? i - 1 : i], corners[area > 0 ? i : i - 1]);
    }
  }
}
