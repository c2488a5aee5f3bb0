package org.selectiverenderer.polygon.simplify;

import java.util.stream.IntStream;

/** How much a reduced mesh differs from its original, measured on both. */
final class Likeness {
  /** Points per mesh at which the looks are compared. */
  private static final int SAMPLES = 1500;

  /** What a shading turned round weighs against a shift by the model's extent. */
  private static final double SHADING = 0.02;

  /** What another material weighs likewise. */
  private static final double MATERIAL = 0.02;

  private final JoinedMesh original;
  private final double extent;

  Likeness(JoinedMesh original) {
    this.original = original;
    this.extent = Math.max(original.extent(), Double.MIN_NORMAL);
  }

  /**
   * The largest distance of the original's vertices and triangle centres from the reduced surface,
   * as a share of the original's largest extent.
   */
  double error(JoinedMesh reduced) {
    SurfaceIndex surface = new SurfaceIndex(reduced);
    float[] v = original.vertices();
    int[] indices = original.indices();
    double atVertices =
        IntStream.range(0, original.vertexCount())
            .parallel()
            .mapToDouble(
                vertex -> {
                  int at = JoinedMesh.STRIDE * vertex;
                  return distance(surface, v[at], v[at + 1], v[at + 2]);
                })
            .max()
            .orElse(0);
    double atCentres =
        IntStream.range(0, original.polygons())
            .parallel()
            .mapToDouble(
                t -> {
                  int a = JoinedMesh.STRIDE * indices[3 * t];
                  int b = JoinedMesh.STRIDE * indices[3 * t + 1];
                  int c = JoinedMesh.STRIDE * indices[3 * t + 2];
                  return distance(
                      surface,
                      ((double) v[a] + v[b] + v[c]) / 3,
                      ((double) v[a + 1] + v[b + 1] + v[c + 1]) / 3,
                      ((double) v[a + 2] + v[b + 2] + v[c + 2]) / 3);
                })
            .max()
            .orElse(0);
    return Math.sqrt(Math.max(atVertices, atCentres)) / extent;
  }

  private static double distance(SurfaceIndex surface, double x, double y, double z) {
    double[] square = new double[1];
    surface.nearest(x, y, z, square);
    return square[0];
  }

  /**
   * What a viewer sees of the difference: distance, shading and material, averaged over both
   * surfaces. Comparable between reductions of one model only.
   */
  double difference(JoinedMesh reduced) {
    return (oneWay(original, reduced) + oneWay(reduced, original)) / 2;
  }

  private double oneWay(JoinedMesh from, JoinedMesh to) {
    SurfaceIndex surface = new SurfaceIndex(to);
    double[] upTo = new double[from.polygons()];
    double area = 0;
    for (int t = 0; t < upTo.length; t++) {
      area += Areas.area(from.vertices(), from.indices(), t);
      upTo[t] = area;
    }
    double sum = 0;
    double[] point = new double[6];
    double[] normal = new double[6];
    double[] square = new double[1];
    int triangle = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double wanted = (i + 0.5) / SAMPLES * area;
      while (triangle < upTo.length - 1 && upTo[triangle] < wanted) {
        triangle++;
      }
      sample(from, triangle, i, point);
      int nearest = surface.nearest(point[0], point[1], point[2], square);
      mean(to, nearest, normal);
      double cosine = point[3] * normal[3] + point[4] * normal[4] + point[5] * normal[5];
      boolean sameMaterial =
          from.part(from.indices()[3 * triangle]) == to.part(to.indices()[3 * nearest]);
      sum +=
          Math.sqrt(square[0]) / extent
              + SHADING * (1 - cosine) / 2
              + (sameMaterial ? 0 : MATERIAL);
    }
    return sum / SAMPLES;
  }

  /** A point of the triangle, a different one for each i (a low-discrepancy sequence). */
  private static void sample(JoinedMesh mesh, int triangle, int i, double[] point) {
    double s = i * 0.7548776662466927 % 1;
    double t = i * 0.5698402909980532 % 1;
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    interpolate(mesh, triangle, 1 - s - t, s, t, point);
  }

  private static void mean(JoinedMesh mesh, int triangle, double[] point) {
    interpolate(mesh, triangle, 1.0 / 3, 1.0 / 3, 1.0 / 3, point);
  }

  /** Position and unit normal; zeros where there is none. */
  private static void interpolate(
      JoinedMesh mesh, int triangle, double r, double s, double t, double[] point) {
    float[] v = mesh.vertices();
    int a = JoinedMesh.STRIDE * mesh.indices()[3 * triangle];
    int b = JoinedMesh.STRIDE * mesh.indices()[3 * triangle + 1];
    int c = JoinedMesh.STRIDE * mesh.indices()[3 * triangle + 2];
    for (int i = 0; i < 6; i++) {
      point[i] = r * v[a + i] + s * v[b + i] + t * v[c + i];
    }
    double length = Math.sqrt(point[3] * point[3] + point[4] * point[4] + point[5] * point[5]);
    for (int i = 3; i < 6; i++) {
      point[i] = length > 0 ? point[i] / length : 0;
    }
  }
}
