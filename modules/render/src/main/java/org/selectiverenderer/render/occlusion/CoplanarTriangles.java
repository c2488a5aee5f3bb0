package org.selectiverenderer.render.occlusion;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;

/** Collects coplanar triangles that face the same way. */
final class CoplanarTriangles {
  /**
   * The largest sine of the angle between plane and triangles, since the normals of thin triangles
   * are inexact.
   */
  private static final double MOST_TILT = 1e-3;

  /** Rejects most triangles without computing the sine. */
  private static final double LEAST_COSINE = 0.999;

  /** The largest distance from the plane, as a share of the mesh's size. */
  private static final double FLATNESS = 1e-5;

  private final float[] positions;
  private final int[] indices;
  private final double tolerance;
  private final double[] n = new double[3];
  private final double[] cross = new double[3];
  private double d;
  private double area;
  private double tilt;
  private int[] triangles = new int[16];
  private int count;

  /**
   * Makes a collection without a plane, which holds nothing.
   *
   * @param indices three per triangle
   * @param tolerance the largest distance of a vertex from the plane
   */
  CoplanarTriangles(float[] positions, int[] indices, double tolerance) {
    this.positions = positions;
    this.indices = indices;
    this.tolerance = tolerance;
  }

  /**
   * Returns the largest distance of a vertex from the plane.
   *
   * @param size of the mesh
   * @param reach the distance from the origin as {@link RasterErrorBounds#reach} returns it for the
   *     mesh, which determines the rounding of coordinates
   */
  static double tolerance(double size, double reach) {
    return FLATNESS * size + 0x1p-22 * reach;
  }

  /**
   * Takes a triangle's plane; the area is 0 at first.
   *
   * @param i the place of its first index
   * @param normal its normal, of any length
   */
  void begin(int i, double[] normal, double length) {
    for (int axis = 0; axis < 3; axis++) {
      n[axis] = normal[axis] / length;
    }
    d = along(indices[i]);
    area = 0;
  }

  private double along(int vertex) {
    return n[0] * positions[3 * vertex]
        + n[1] * positions[3 * vertex + 1]
        + n[2] * positions[3 * vertex + 2];
  }

  /** Returns whether a triangle lies in the plane; parameters as for {@link #begin}. */
  boolean holds(int i, double[] normal, double length) {
    double cosine = n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2];
    return cosine > LEAST_COSINE * length
        && Math.abs(along(indices[i]) - d) <= tolerance
        && Math.abs(along(indices[i + 1]) - d) <= tolerance
        && Math.abs(along(indices[i + 2]) - d) <= tolerance
        && sine(normal, length) <= MOST_TILT;
  }

  private double sine(double[] normal, double length) {
    TriangleMath.cross(n[0], n[1], n[2], normal[0], normal[1], normal[2], cross);
    return TriangleMath.length(cross) / length;
  }

  boolean samePlane(CoplanarTriangles other) {
    return n[0] * other.n[0] + n[1] * other.n[1] + n[2] * other.n[2] > LEAST_COSINE
        && sine(other.n, 1) <= MOST_TILT
        && Math.abs(d - other.d) <= tolerance;
  }

  /** Returns the area of its triangles. */
  double area() {
    return area;
  }

  void grow(double by) {
    area += by;
  }

  /** Resets the area, and keeps the plane. */
  void clear() {
    area = 0;
  }

  /** Adds a triangle that lies in the plane. */
  void add(int i, double[] normal, double length) {
    if (count == triangles.length) {
      triangles = Arrays.copyOf(triangles, 2 * count);
    }
    triangles[count++] = i;
    area += length / 2;
    tilt = Math.max(tilt, sine(normal, length));
  }

  /** Returns the occluder polygon of the triangles that were added. */
  OccluderPolygon patch() {
    OccluderOutline outline = new OccluderOutline(positions);
    double thickness = 0;
    for (int t = 0; t < count; t++) {
      int i = triangles[t];
      for (int corner = 0; corner < 3; corner++) {
        int v = indices[i + corner];
        thickness = Math.max(thickness, Math.abs(along(v) - d));
        outline.toggle(v, indices[i + (corner + 1) % 3]);
      }
    }
    return outline.patch(new double[] {n[0], n[1], n[2], d}, thickness, tilt, area);
  }
}
