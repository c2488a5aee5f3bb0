package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;

/**
 * The growing list of a node's triangles. A corner is represented by its position in the node's
 * index stream, which determines its point and the indices of its colour, normal and texture
 * coordinate.
 */
final class TriangleListBuilder {
  private final int[] stream;
  private int[] corners;
  private int[] faces;
  private int count;

  /**
   * Creates an empty list.
   *
   * @param stream point index per stream position
   * @param expected the expected number of triangles
   */
  TriangleListBuilder(int[] stream, int expected) {
    this.stream = stream;
    this.corners = new int[3 * Math.max(4, expected)];
    this.faces = new int[Math.max(4, expected)];
  }

  /** Adds a triangle of a face; a, b, c are stream positions. */
  void add(int a, int b, int c, int face) {
    if (count == faces.length) {
      faces = Arrays.copyOf(faces, 2 * count);
      corners = Arrays.copyOf(corners, 6 * count);
    }
    int at = 3 * count;
    corners[at] = a;
    corners[at + 1] = b;
    corners[at + 2] = c;
    faces[count++] = face;
  }

  int count() {
    return count;
  }

  /** Returns the point index per stream position. */
  int[] stream() {
    return stream;
  }

  /** Returns the point index at a stream position. */
  int point(int position) {
    return stream[position];
  }

  /** Returns stream positions, three per triangle; the array may be longer than needed. */
  int[] corners() {
    return corners;
  }

  /** Returns the face of each triangle; the array may be longer than needed. */
  int[] faces() {
    return faces;
  }

  /** Returns the point of each corner, three per triangle, in an array of exact length. */
  int[] points() {
    int[] points = new int[3 * count];
    for (int i = 0; i < points.length; i++) {
      points[i] = stream[corners[i]];
    }
    return points;
  }

  /** Reverses the winding of all triangles, for nodes whose {@code ccw} is FALSE. */
  void reverse() {
    for (int i = 0; i < 3 * count; i += 3) {
      int kept = corners[i + 1];
      corners[i + 1] = corners[i + 2];
      corners[i + 2] = kept;
    }
  }

  /**
   * Removes degenerate triangles, whose height is less than about 1e-8 of their longest side; these
   * are lines bent by rounding.
   *
   * @param xyz the points
   * @return the number of triangles removed
   */
  int dropDegenerate(float[] xyz) {
    int kept = 0;
    for (int t = 0; t < count; t++) {
      int at = 3 * t;
      int a = 3 * stream[corners[at]];
      int b = 3 * stream[corners[at + 1]];
      int c = 3 * stream[corners[at + 2]];
      if (TriangleMath.hasArea(xyz, a, b, c, 1e-16)) {
        if (kept != t) {
          corners[3 * kept] = corners[at];
          corners[3 * kept + 1] = corners[at + 1];
          corners[3 * kept + 2] = corners[at + 2];
          faces[kept] = faces[t];
        }
        kept++;
      }
    }
    int dropped = count - kept;
    count = kept;
    return dropped;
  }
}
