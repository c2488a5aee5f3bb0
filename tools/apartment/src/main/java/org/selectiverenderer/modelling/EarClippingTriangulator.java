package org.selectiverenderer.modelling;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/**
 * Triangulates a polygon with holes by ear clipping. The triangles use every point, those on
 * straight edges too, so that walls built on the outline meet the cap without T-junctions. The ear
 * with the best shape is clipped first. Quadratic to cubic in the number of points, which is small.
 */
final class EarClippingTriangulator {
  private final double[] xy;
  private final TriangleMeshBuilder out;
  private final int[] ring;
  private final double[] score;
  private int size;

  private EarClippingTriangulator(double[] xy, int[] ring, TriangleMeshBuilder out) {
    this.xy = xy;
    this.ring = ring;
    this.out = out;
    this.size = ring.length;
    this.score = new double[size];
  }

  /**
   * Adds {@code n - 2 + 2 * holes} triangles, counter-clockwise, to the mesh.
   *
   * @param rings the outline counter-clockwise, then its holes clockwise, x, y per point; their
   *     points are the mesh's points 0, 1, 2 ... in this order, plus {@code first}
   */
  static void fill(double[][] rings, int first, TriangleMeshBuilder out) {
    int total = Arrays.stream(rings).mapToInt(r -> r.length).sum();
    double[] xy = new double[total];
    int used = 0;
    for (double[] ring : rings) {
      System.arraycopy(ring, 0, xy, used, ring.length);
      used += ring.length;
    }
    TriangleMeshBuilder flat = new TriangleMeshBuilder();
    new EarClippingTriangulator(xy, PolygonHoleBridging.join(rings, xy), flat).clip();
    int[] triangles = flat.mesh().triangles();
    for (int i = 0; i < triangles.length; i += 3) {
      out.triangle(first + triangles[i], first + triangles[i + 1], first + triangles[i + 2]);
    }
  }

  private void clip() {
    for (int i = 0; i < size; i++) {
      score[i] = quality(i);
    }
    while (size > 3) {
      int best = best();
      if (score[best] <= 0) {
        for (int i = 0; i < size; i++) {
          score[i] = quality(i);
        }
        best = best();
        if (score[best] <= 0) {
          throw new IllegalArgumentException("the outline crosses or touches itself");
        }
      }
      out.triangle(ring[(best + size - 1) % size], ring[best], ring[(best + 1) % size]);
      System.arraycopy(ring, best + 1, ring, best, size - best - 1);
      System.arraycopy(score, best + 1, score, best, size - best - 1);
      size--;
      int after = best % size;
      int before = (best + size - 1) % size;
      score[before] = quality(before);
      score[after] = quality(after);
    }
    out.triangle(ring[0], ring[1], ring[2]);
  }

  private int best() {
    int best = 0;
    for (int i = 1; i < size; i++) {
      if (score[i] > score[best]) {
        best = i;
      }
    }
    return best;
  }

  /**
   * Returns the quality of an ear, its area over the square of its longest side; 0 for a corner
   * that is not an ear.
   */
  private double quality(int i) {
    int a = ring[(i + size - 1) % size];
    int b = ring[i];
    int c = ring[(i + 1) % size];
    double area = TriangleMath.turn(xy, a, b, c);
    double longest =
        Math.max(
            PolygonHoleBridging.square(xy, a, b),
            Math.max(PolygonHoleBridging.square(xy, b, c), PolygonHoleBridging.square(xy, c, a)));
    if (area <= 1e-9 * longest) {
      return 0;
    }
    double slack = -1e-9 * longest;
    for (int k = 0; k < size; k++) {
      int p = ring[k];
      if (!same(p, a)
          && !same(p, b)
          && !same(p, c)
          && TriangleMath.turn(xy, a, b, p) >= slack
          && TriangleMath.turn(xy, b, c, p) >= slack
          && TriangleMath.turn(xy, c, a, p) >= slack) {
        return 0;
      }
    }
    return area / longest;
  }

  private boolean same(int a, int b) {
    return a == b || xy[2 * a] == xy[2 * b] && xy[2 * a + 1] == xy[2 * b + 1];
  }
}
