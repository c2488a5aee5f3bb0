package org.selectiverenderer.geometry;

/**
 * Normals and areas of triangles and polygons whose points lie in arrays. Differences and products
 * are taken in double precision in one fixed order, so that the same input gives the same bits
 * everywhere; nothing is allocated.
 */
public final class TriangleMath {
  private TriangleMath() {}

  /** The cross product u x v into {@code out}. */
  public static void cross(
      double ux, double uy, double uz, double vx, double vy, double vz, double[] out) {
    out[0] = uy * vz - uz * vy;
    out[1] = uz * vx - ux * vz;
    out[2] = ux * vy - uy * vx;
  }

  /** The triple product n . (u x v). */
  public static double triple(
      double[] n, double ux, double uy, double uz, double vx, double vy, double vz) {
    return n[0] * (uy * vz - uz * vy) + n[1] * (uz * vx - ux * vz) + n[2] * (ux * vy - uy * vx);
  }

  /**
   * A vector across a triangle, to the side from which it goes counter-clockwise, twice as long as
   * its area.
   *
   * @param p x, y, z per point
   * @param a where the first corner's x lies; {@code b} and {@code c} likewise
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

  /** Likewise, of points in double precision. */
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
   * Twice a polygon's area vector (Newell's method), taken from its first point for accuracy. Of a
   * polygon that is not quite flat it is the direction in which it shows the largest area.
   *
   * @param p x, y, z per point
   * @param points the polygon's, at {@code from} up to {@code to}
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

  /** The length of a vector. */
  public static double length(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  /** Brings a vector to length 1, unless it has none; returns the length it had. */
  public static double normalize(double[] v) {
    double length = length(v);
    double scale = length > 0 ? 1 / length : 0;
    v[0] *= scale;
    v[1] *= scale;
    v[2] *= scale;
    return length;
  }

  /**
   * Whether a triangle has an area to speak of: rounding bends lines into very thin triangles.
   *
   * @param p as for {@link #normal(float[], int, int, int, double[])}
   * @param share about the square of the height, in longest sides, that is too little
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

  /** Twice the area of a triangle in the plane, negative when it goes clockwise. */
  public static double turn(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  }

  /**
   * Likewise, of points in an array.
   *
   * @param xy x, y per point
   * @param a number of the first point
   */
  public static double turn(double[] xy, int a, int b, int c) {
    return turn(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]);
  }
}
