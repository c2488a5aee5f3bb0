package org.selectiverenderer.radiosity.trace;

import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;

/**
 * All triangles of a scene in world coordinates.
 *
 * @param corners nine numbers per triangle: x, y, z of its three corners, metres, counter-clockwise
 *     seen from its front; all finite
 * @param twoSided per triangle: whether it is visible from behind, too
 * @param transmittance per triangle: the share of light that passes straight through
 * @param version per triangle: the version of an object that it belongs to, {@link
 *     ObjectVersionIndex#FIXED} for none
 */
public record SceneTriangles(
    float[] corners, boolean[] twoSided, float[] transmittance, int[] version) {

  public int count() {
    return twoSided.length;
  }

  /** Returns a bounding volume hierarchy over some triangles; its items are indices of members. */
  public Bvh tree(int[] members) {
    return BvhBuilder.build(
        members.length,
        (item, box) -> {
          int at = 9 * members[item];
          for (int axis = 0; axis < 3; axis++) {
            float a = corners[at + axis];
            float b = corners[at + 3 + axis];
            float c = corners[at + 6 + axis];
            box[axis] = Math.min(a, Math.min(b, c));
            box[axis + 3] = Math.max(a, Math.max(b, c));
          }
        });
  }

  /** Writes the unit normal of a triangle to {@code out}; returns its area. */
  public double normal(int triangle, double[] out) {
    int at = 9 * triangle;
    TriangleMath.normal(corners, at, at + 3, at + 6, out);
    return TriangleMath.normalize(out) / 2;
  }

  /**
   * Writes the point of a triangle with the given barycentric weights of its second and third
   * corner to {@code out}.
   */
  public void point(int triangle, double u, double v, double[] out) {
    int at = 9 * triangle;
    double w = 1 - u - v;
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = w * corners[at + axis] + u * corners[at + 3 + axis] + v * corners[at + 6 + axis];
    }
  }

  /**
   * Computes the barycentric weights of a triangle's second and third corner at a point in its
   * plane, clamped to the triangle.
   *
   * @param corners nine numbers per triangle
   * @param out receives the two weights
   * @return by how much the weights were clamped; 0 for a point inside
   */
  public static double weights(float[] corners, int triangle, double[] point, double[] out) {
    double bb = 0;
    double bc = 0;
    double cc = 0;
    double pb = 0;
    double pc = 0;
    int at = 9 * triangle;
    for (int axis = 0; axis < 3; axis++) {
      double b = (double) corners[at + 3 + axis] - corners[at + axis];
      double c = (double) corners[at + 6 + axis] - corners[at + axis];
      double p = point[axis] - corners[at + axis];
      bb += b * b;
      bc += b * c;
      cc += c * c;
      pb += p * b;
      pc += p * c;
    }
    double scale = bb * cc - bc * bc;
    double u = scale > 0 ? (cc * pb - bc * pc) / scale : 0;
    double v = scale > 0 ? (bb * pc - bc * pb) / scale : 0;
    out[0] = Math.max(0, Math.min(1, u));
    out[1] = Math.max(0, Math.min(1 - out[0], v));
    return Math.abs(out[0] - u) + Math.abs(out[1] - v);
  }
}
