package org.selectiverenderer.geometry.font;

import earcut4j.Earcut;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * Triangulates glyph outlines. As TrueType defines it, clockwise contours are outer boundaries and
 * the others are holes in the smallest contour around them.
 */
final class GlyphTriangulator {
  private static final int DIRECTIONS = 8;

  private GlyphTriangulator() {}

  /**
   * Returns the glyph of the contours.
   *
   * @param contours x, y per point
   * @param scale ems per unit of the contours
   */
  static Glyph fill(List<float[]> contours, float advance, float scale) {
    List<float[]> outer = new ArrayList<>();
    List<float[]> holes = new ArrayList<>();
    for (float[] contour : contours) {
      (area(contour) <= 0 ? outer : holes).add(contour);
    }
    List<List<float[]>> groups = new ArrayList<>();
    for (float[] contour : outer) {
      groups.add(new ArrayList<>(List.of(contour)));
    }
    for (float[] hole : holes) {
      List<float[]> around = null;
      for (List<float[]> group : groups) {
        float[] contour = group.get(0);
        if (contains(contour, hole)
            && (around == null || Math.abs(area(contour)) < Math.abs(area(around.get(0))))) {
          around = group;
        }
      }
      if (around == null) {
        groups.add(new ArrayList<>(List.of(hole)));
      } else {
        around.add(hole);
      }
    }
    return triangulate(groups, advance, scale);
  }

  private static Glyph triangulate(List<List<float[]>> groups, float advance, float scale) {
    int values = 0;
    for (List<float[]> group : groups) {
      for (float[] contour : group) {
        values += contour.length;
      }
    }
    float[] points = new float[values];
    List<Integer> indices = new ArrayList<>();
    int used = 0;
    for (List<float[]> group : groups) {
      int first = used / 2;
      int[] holes = new int[group.size() - 1];
      for (int i = 0; i < group.size(); i++) {
        if (i > 0) {
          holes[i - 1] = used / 2 - first;
        }
        System.arraycopy(group.get(i), 0, points, used, group.get(i).length);
        used += group.get(i).length;
      }
      for (int index : clip(points, first, used / 2, holes)) {
        indices.add(first + index);
      }
    }
    int[] triangles = new int[indices.size()];
    for (int i = 0; i < triangles.length; i++) {
      triangles[i] = indices.get(i);
    }
    for (int i = 0; i < triangles.length; i += 3) {
      if (turnsRight(points, triangles[i], triangles[i + 1], triangles[i + 2])) {
        int kept = triangles[i + 1];
        triangles[i + 1] = triangles[i + 2];
        triangles[i + 2] = kept;
      }
    }
    for (int i = 0; i < points.length; i++) {
      points[i] *= scale;
    }
    return new Glyph(advance, points, triangles);
  }

  /**
   * Triangulates a contour with holes by ear clipping. earcut4j fails to bridge some holes,
   * depending on the direction of its search, and fills them. This is detected by the area, and the
   * contour is triangulated again in rotated directions.
   */
  private static List<Integer> clip(float[] points, int first, int end, int[] holes) {
    List<Integer> best = List.of();
    double least = Double.POSITIVE_INFINITY;
    for (int attempt = 0; attempt < DIRECTIONS; attempt++) {
      double sine = Math.sin(2 * Math.PI * attempt / DIRECTIONS);
      double cosine = Math.cos(2 * Math.PI * attempt / DIRECTIONS);
      double[] plane = new double[2 * (end - first)];
      for (int i = 0; i < plane.length; i += 2) {
        double x = points[2 * first + i];
        double y = points[2 * first + i + 1];
        plane[i] = cosine * x - sine * y;
        plane[i + 1] = sine * x + cosine * y;
      }
      List<Integer> triangles = Earcut.earcut(plane, holes, 2);
      double excess = excess(plane, holes, triangles);
      if (excess < least) {
        least = excess;
        best = triangles;
      }
      if (least < 1e-3) {
        break;
      }
    }
    return best;
  }

  /** Returns the relative error of the triangles' area against the area of the outline. */
  private static double excess(double[] plane, int[] holes, List<Integer> triangles) {
    double wanted = 0;
    for (int ring = 0, from = 0; ring <= holes.length; ring++) {
      int to = ring == holes.length ? plane.length / 2 : holes[ring];
      double area = 0;
      for (int i = from, j = to - 1; i < to; j = i++) {
        area += plane[2 * j] * plane[2 * i + 1] - plane[2 * i] * plane[2 * j + 1];
      }
      wanted += ring == 0 ? Math.abs(area) : -Math.abs(area);
      from = to;
    }
    double filled = 0;
    for (int i = 0; i < triangles.size(); i += 3) {
      int a = triangles.get(i);
      filled += Math.abs(TriangleMath.turn(plane, a, triangles.get(i + 1), triangles.get(i + 2)));
    }
    return Math.abs(filled - wanted) / Math.max(1e-9, wanted);
  }

  private static boolean turnsRight(float[] points, int a, int b, int c) {
    return TriangleMath.turn(
            points[2 * a],
            points[2 * a + 1],
            points[2 * b],
            points[2 * b + 1],
            points[2 * c],
            points[2 * c + 1])
        < 0;
  }

  /** Returns the signed area of a polygon, negative if it is clockwise. */
  static double area(float[] polygon) {
    double sum = 0;
    for (int i = 0, j = polygon.length - 2; i < polygon.length; j = i, i += 2) {
      sum += (double) polygon[j] * polygon[i + 1] - (double) polygon[i] * polygon[j + 1];
    }
    return sum / 2;
  }

  /** Returns whether most points of the other polygon are inside; outlines may touch. */
  private static boolean contains(float[] polygon, float[] other) {
    int inside = 0;
    for (int i = 0; i < other.length; i += 2) {
      inside += contains(polygon, other[i], other[i + 1]) ? 1 : 0;
    }
    return 4 * inside > other.length;
  }

  private static boolean contains(float[] polygon, float x, float y) {
    boolean inside = false;
    for (int i = 0, j = polygon.length - 2; i < polygon.length; j = i, i += 2) {
      float yi = polygon[i + 1];
      float yj = polygon[j + 1];
      if (yi > y != yj > y) {
        double cross = (double) (polygon[j] - polygon[i]) * (y - yi) / (yj - yi) + polygon[i];
        inside ^= x < cross;
      }
    }
    return inside;
  }
}
