package org.selectiverenderer.geometry;

/**
 * Computes normals and areas of triangles and polygons whose points are stored in arrays. The
 * arithmetic is in double precision and in a fixed order, so that results are bit-identical on
 * every machine; nothing is allocated.
 */
public final class TriangleMath {
  /** Points of a face count as collinear below this sine of their angle. */
  private static final double STRAIGHT = 1e-7;

  private TriangleMath() {}

  /** Computes the cross product u x v into {@code out}. */
  public static void cross(
      double ux, double uy, double uz, double vx, double vy, double vz, double[] out) {
    out[0] = uy * vz - uz * vy;
    out[1] = uz * vx - ux * vz;
    out[2] = ux * vy - uy * vx;
  }

  /** Returns the scalar triple product n . (u x v). */
  public static double triple(
      double[] n, double ux, double uy, double uz, double vx, double vy, double vz) {
    return n[0] * (uy * vz - uz * vy) + n[1] * (uz * vx - ux * vz) + n[2] * (ux * vy - uy * vx);
  }

  /**
   * Computes the normal of a triangle, which points to the side from which the corners run
   * counter-clockwise. Its length is twice the area.
   *
   * @param p x, y, z per point
   * @param a the index in {@code p} of the first corner's x; {@code b} and {@code c} likewise
   */
  public static void normal(float[] p, int a, int b, int c, double[] out) {
    cross(
        (double) p[b] - p[a],
        (double) p[b + 1] - p[a + 1],
        (double) p[b + 2] - p[a + 2],
        (double) p[c] - p[a],
        (double) p[c + 1] - p[a + 1],
        (double) p[c + 2] - p[a + 2],
        out);
  }

  /** Computes the normal of a triangle with points in double precision. */
  public static void normal(double[] p, int a, int b, int c, double[] out) {
    cross(
        p[b] - p[a],
        p[b + 1] - p[a + 1],
        p[b + 2] - p[a + 2],
        p[c] - p[a],
        p[c + 1] - p[a + 1],
        p[c + 2] - p[a + 2],
        out);
  }

  /**
   * Computes twice a polygon's area vector (Newell's method), relative to its first point for
   * accuracy. For a non-planar polygon it is the direction of the largest projected area.
   *
   * @param p x, y, z per point
   * @param points indices of the polygon's points, from {@code from} up to but not including {@code
   *     to}
   */
  public static void newell(float[] p, int[] points, int from, int to, double[] out) {
    int origin = 3 * points[from];
    double x = 0;
    double y = 0;
    double z = 0;
    for (int i = from + 2; i < to; i++) {
      normal(p, origin, 3 * points[i - 1], 3 * points[i], out);
      x += out[0];
      y += out[1];
      z += out[2];
    }
    out[0] = x;
    out[1] = y;
    out[2] = z;
  }

  /**
   * Returns whether a face has an area: its points do not coincide or lie on a line. The area by
   * Newell's method is compared with the square of the longest distance from the first point.
   *
   * @param p points, x, y, z each
   * @param points indices of points; the face has those of {@code from} to {@code to}
   */
  public static boolean hasArea(float[] p, int[] points, int from, int to) {
    int origin = 3 * points[from];
    double longest = 0;
    for (int i = from + 1; i < to; i++) {
      int at = 3 * points[i];
      double x = (double) p[at] - p[origin];
      double y = (double) p[at + 1] - p[origin + 1];
      double z = (double) p[at + 2] - p[origin + 2];
      longest = Math.max(longest, x * x + y * y + z * z);
    }
    double[] normal = new double[3];
    newell(p, points, from, to, normal);
    return !Double.isFinite(longest) || length(normal) > STRAIGHT * longest;
  }

  /** Returns the length of a vector. */
  public static double length(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  /** Normalizes a vector unless its length is 0; returns its original length. */
  public static double normalize(double[] v) {
    double length = length(v);
    double scale = length > 0 ? 1 / length : 0;
    v[0] *= scale;
    v[1] *= scale;
    v[2] *= scale;
    return length;
  }

  /**
   * Returns whether a triangle is not degenerate; rounding turns collinear points into very thin
   * triangles.
   *
   * @param p as for {@link #normal(float[], int, int, int, double[])}
   * @param share the threshold, about the square of the ratio of the height to the longest side
   */
  public static boolean hasArea(float[] p, int a, int b, int c, double share) {
    double ux = (double) p[b] - p[a];
    double uy = (double) p[b + 1] - p[a + 1];
    double uz = (double) p[b + 2] - p[a + 2];
    double vx = (double) p[c] - p[a];
    double vy = (double) p[c + 1] - p[a + 1];
    double vz = (double) p[c + 2] - p[a + 2];
    double nx = uy * vz - uz * vy;
    double ny = uz * vx - ux * vz;
    double nz = ux * vy - uy * vx;
    double sides = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz;
    return nx * nx + ny * ny + nz * nz > share * sides * sides;
  }

  /** Returns twice the signed area of a 2D triangle, negative if it is clockwise (orient2d). */
  public static double turn(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  }

  /**
   * Returns twice the signed area of a 2D triangle whose points are in an array.
   *
   * @param xy x, y per point
   * @param a index of the first point
   */
  public static double turn(double[] xy, int a, int b, int c) {
    return turn(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]);
  }
}
