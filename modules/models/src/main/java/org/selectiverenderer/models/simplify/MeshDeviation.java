package org.selectiverenderer.models.simplify;

import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * Measures how much a reduced mesh deviates from its original, in geometry and in appearance. Not
 * thread-safe.
 */
final class MeshDeviation {
  private static final int BLOCK = 4096;

  /**
   * With this many polygons, triangles are so small that the distances of their vertices suffice.
   */
  private static final int DENSE = 200_000;

  /** Number of sample points per mesh at which the appearance is compared. */
  private static final int SAMPLES = 1500;

  /** Weight of an opposite normal relative to a displacement by the model's extent. */
  private static final double SHADING = 0.02;

  /** Weight of a different material relative to a displacement by the model's extent. */
  private static final double MATERIAL = 0.02;

  private final MergedMesh original;
  private final double extent;
  private @Nullable TriangleBvh originalSurface;

  MeshDeviation(MergedMesh original) {
    this.original = original;
    this.extent = Math.max(original.extent(), Double.MIN_NORMAL);
  }

  /**
   * The largest distance of the original's vertices and triangle centres from the reduced surface,
   * as a share of the original's largest extent (a one-sided Hausdorff distance, sampled). Where
   * triangles are small, only vertices are measured.
   */
  double error(MergedMesh reduced) {
    TriangleBvh surface = new TriangleBvh(reduced);
    boolean dense = original.polygons() > DENSE;
    int points = original.vertexCount() + (dense ? 0 : original.polygons());
    double square =
        IntStream.range(0, (points + BLOCK - 1) / BLOCK)
            .parallel()
            .mapToDouble(
                block -> largest(surface, block * BLOCK, Math.min(points, block * BLOCK + BLOCK)))
            .max()
            .orElse(0);
    return Math.sqrt(square) / extent;
  }

  /**
   * Returns the largest squared distance of a range of points. Points with adjacent numbers are
   * mostly adjacent in space, so the triangle nearest to one often bounds the distance of the next
   * one tightly enough to skip its search.
   */
  private double largest(TriangleBvh surface, int from, int to) {
    double largest = 0;
    int near = -1;
    double[] point = new double[3];
    double[] square = new double[1];
    for (int i = from; i < to; i++) {
      point(i, point);
      if (near >= 0 && surface.square(near, point[0], point[1], point[2]) <= largest) {
        continue;
      }
      near = surface.nearest(point[0], point[1], point[2], near, square);
      largest = Math.max(largest, square[0]);
    }
    return largest;
  }

  /**
   * Returns a point by its number: the original's vertices first, then the centres of its
   * triangles.
   */
  private void point(int number, double[] point) {
    float[] v = original.vertices();
    int triangle = number - original.vertexCount();
    for (int axis = 0; axis < 3; axis++) {
      if (triangle < 0) {
        point[axis] = v[MergedMesh.STRIDE * number + axis];
      } else {
        double sum = 0;
        for (int corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
          sum += v[MergedMesh.STRIDE * original.indices()[corner] + axis];
        }
        point[axis] = sum / 3;
      }
    }
  }

  /**
   * Returns a measure of the visible difference: distance, shading and material, averaged over
   * samples of both surfaces. Only reductions of the same model can be compared by it.
   */
  double difference(MergedMesh reduced) {
    if (originalSurface == null) {
      originalSurface = new TriangleBvh(original);
    }
    double there = oneWay(original, reduced, new TriangleBvh(reduced));
    double back = oneWay(reduced, original, originalSurface);
    return (there + back) / 2;
  }

  private double oneWay(MergedMesh from, MergedMesh to, TriangleBvh surface) {
    double[] upTo = new double[from.polygons()];
    double area = 0;
    for (int t = 0; t < upTo.length; t++) {
      area += TriangleAreas.area(from.vertices(), from.indices(), t);
      upTo[t] = area;
    }
    double sum = 0;
    double[] point = new double[6];
    double[] normal = new double[6];
    double[] square = new double[1];
    int triangle = 0;
    int nearest = -1;
    for (int i = 0; i < SAMPLES; i++) {
      double wanted = (i + 0.5) / SAMPLES * area;
      while (triangle < upTo.length - 1 && upTo[triangle] < wanted) {
        triangle++;
      }
      sample(from, triangle, i, point);
      nearest = surface.nearest(point[0], point[1], point[2], nearest, square);
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

  /** Computes sample point i of a triangle by a low-discrepancy sequence. */
  private static void sample(MergedMesh mesh, int triangle, int i, double[] point) {
    double s = i * 0.7548776662466927 % 1;
    double t = i * 0.5698402909980532 % 1;
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    interpolate(mesh, triangle, 1 - s - t, s, t, point);
  }

  private static void mean(MergedMesh mesh, int triangle, double[] point) {
    interpolate(mesh, triangle, 1.0 / 3, 1.0 / 3, 1.0 / 3, point);
  }

  /**
   * Interpolates position and unit normal at barycentric coordinates; the normal is 0 where there
   * is none.
   */
  private static void interpolate(
      MergedMesh mesh, int triangle, double r, double s, double t, double[] point) {
    float[] v = mesh.vertices();
    int a = MergedMesh.STRIDE * mesh.indices()[3 * triangle];
    int b = MergedMesh.STRIDE * mesh.indices()[3 * triangle + 1];
    int c = MergedMesh.STRIDE * mesh.indices()[3 * triangle + 2];
    for (int i = 0; i < 6; i++) {
      point[i] = r * v[a + i] + s * v[b + i] + t * v[c + i];
    }
    double length = Math.sqrt(point[3] * point[3] + point[4] * point[4] + point[5] * point[5]);
    for (int i = 3; i < 6; i++) {
      point[i] = length > 0 ? point[i] / length : 0;
    }
  }
}
