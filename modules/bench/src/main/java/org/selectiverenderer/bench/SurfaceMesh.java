package org.selectiverenderer.bench;

import org.selectiverenderer.geometry.TriangleMath;

/**
 * A shape tessellated into {@code 2 * rows * columns} triangles, with a normal per point.
 *
 * @param points x y z per point, metres
 * @param normals x y z per point, unit length, outwards
 * @param triangles three indices each, counter-clockwise seen from outside
 */
record SurfaceMesh(double[] points, double[] normals, int[] triangles) {

  static SurfaceMesh of(BenchSurface form, double phase, int rows, int columns) {
    int grid = rows * columns;
    double[] points = new double[3 * (form.isRing() ? grid : grid + 2)];
    double[] point = new double[3];
    for (int r = 0; r < rows; r++) {
      double u = form.isRing() ? (double) r / rows : (r + 1.0) / (rows + 1);
      for (int c = 0; c < columns; c++) {
        form.point(u, (double) c / columns, phase, point);
        System.arraycopy(point, 0, points, 3 * (r * columns + c), 3);
      }
    }
    if (!form.isRing()) {
      form.point(0, 0, phase, point);
      System.arraycopy(point, 0, points, 3 * grid, 3);
      form.point(1, 0, phase, point);
      System.arraycopy(point, 0, points, 3 * grid + 3, 3);
    }
    int[] triangles = triangles(form.isRing(), rows, columns);
    if (volume(points, triangles) < 0) {
      turnOver(triangles);
    }
    return new SurfaceMesh(points, normals(points, triangles), triangles);
  }

  private static int[] triangles(boolean ring, int rows, int columns) {
    int[] out = new int[6 * rows * columns];
    int n = 0;
    int grid = rows * columns;
    for (int r = 0; r < (ring ? rows : rows - 1); r++) {
      int next = (r + 1) % rows * columns;
      for (int c = 0; c < columns; c++) {
        int right = (c + 1) % columns;
        n = add(out, n, r * columns + c, r * columns + right, next + right);
        n = add(out, n, r * columns + c, next + right, next + c);
      }
    }
    for (int c = 0; !ring && c < columns; c++) {
      int right = (c + 1) % columns;
      n = add(out, n, grid, right, c);
      n = add(out, n, grid + 1, grid - columns + c, grid - columns + right);
    }
    return out;
  }

  private static int add(int[] out, int at, int a, int b, int c) {
    out[at] = a;
    out[at + 1] = b;
    out[at + 2] = c;
    return at + 3;
  }

  private static double volume(double[] p, int[] triangles) {
    double six = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      int a = 3 * triangles[t];
      int b = 3 * triangles[t + 1];
      int c = 3 * triangles[t + 2];
      six +=
          p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1])
              + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2])
              + p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
    }
    return six;
  }

  private static void turnOver(int[] triangles) {
    for (int t = 0; t < triangles.length; t += 3) {
      int second = triangles[t + 1];
      triangles[t + 1] = triangles[t + 2];
      triangles[t + 2] = second;
    }
  }

  /** Computes point normals: the area-weighted sum of face normals, normalised. */
  private static double[] normals(double[] p, int[] triangles) {
    double[] normals = new double[p.length];
    double[] normal = new double[3];
    for (int t = 0; t < triangles.length; t += 3) {
      int a = 3 * triangles[t];
      int b = 3 * triangles[t + 1];
      int c = 3 * triangles[t + 2];
      TriangleMath.normal(p, a, b, c, normal);
      for (int corner : new int[] {a, b, c}) {
        normals[corner] += normal[0];
        normals[corner + 1] += normal[1];
        normals[corner + 2] += normal[2];
      }
    }
    for (int i = 0; i < normals.length; i += 3) {
      double length =
          Math.sqrt(
              normals[i] * normals[i]
                  + normals[i + 1] * normals[i + 1]
                  + normals[i + 2] * normals[i + 2]);
      for (int k = 0; k < 3; k++) {
        normals[i + k] /= length;
      }
    }
    return normals;
  }
}
