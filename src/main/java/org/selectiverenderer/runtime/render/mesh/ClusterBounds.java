package org.selectiverenderer.runtime.render.mesh;

import org.selectiverenderer.geometry.TriangleMath;

/** Bounding spheres and cones of normals of clusters. */
final class ClusterBounds {
  /** Half angles beyond this (about 84 degrees) are hardly ever culled. */
  private static final double NARROWEST_DOT = 0.1;

  private final float[] positions;
  private final int[] indices;

  /**
   * @param indices of triangles, ordered by cluster
   */
  ClusterBounds(float[] positions, int[] indices) {
    this.positions = positions;
    this.indices = indices;
  }

  /**
   * @param ends where each cluster ends, counted in triangles
   */
  Clusters of(int[] ends) {
    int[] first = new int[ends.length + 1];
    float[] spheres = new float[4 * ends.length];
    float[] cones = new float[4 * ends.length];
    for (int c = 0; c < ends.length; c++) {
      first[c + 1] = 3 * ends[c];
      sphere(first[c], first[c + 1], spheres, 4 * c);
      cone(first[c], first[c + 1], cones, 4 * c);
    }
    return new Clusters(first, spheres, cones);
  }

  /** The sphere around the middle of the box: at most a factor of 1.7 too large, and cheap. */
  private void sphere(int from, int to, float[] out, int at) {
    double radius = 0;
    for (int axis = 0; axis < 3; axis++) {
      float min = Float.POSITIVE_INFINITY;
      float max = Float.NEGATIVE_INFINITY;
      for (int i = from; i < to; i++) {
        float value = positions[3 * indices[i] + axis];
        min = Math.min(min, value);
        max = Math.max(max, value);
      }
      out[at + axis] = (min + max) / 2;
    }
    for (int i = from; i < to; i++) {
      int v = 3 * indices[i];
      double dx = positions[v] - out[at];
      double dy = positions[v + 1] - out[at + 1];
      double dz = positions[v + 2] - out[at + 2];
      radius = Math.max(radius, dx * dx + dy * dy + dz * dz);
    }
    out[at + 3] = Math.nextUp((float) (Math.sqrt(radius) * (1 + 1e-6)));
  }

  private void cone(int from, int to, float[] out, int at) {
    double[] axis = new double[3];
    double[] n = new double[3];
    for (int i = from; i < to; i += 3) {
      if (normal(i, n)) {
        for (int a = 0; a < 3; a++) {
          axis[a] += n[a];
        }
      }
    }
    double length = TriangleMath.length(axis);
    double least = length > 0 ? 1 : -1;
    for (int i = from; i < to && length > 0; i += 3) {
      if (normal(i, n)) {
        least = Math.min(least, (axis[0] * n[0] + axis[1] * n[1] + axis[2] * n[2]) / length);
      }
    }
    for (int a = 0; a < 3; a++) {
      out[at + a] = length > 0 ? (float) (axis[a] / length) : 0;
    }
    out[at + 3] =
        least <= NARROWEST_DOT ? 1 : (float) Math.min(1, Math.sqrt(1 - least * least) + 1e-4);
  }

  /** The unit normal of the triangle that begins at an index; false for one without area. */
  private boolean normal(int i, double[] out) {
    int a = 3 * indices[i];
    int b = 3 * indices[i + 1];
    int c = 3 * indices[i + 2];
    TriangleMath.normal(positions, a, b, c, out);
    double length = TriangleMath.length(out);
    for (int axis = 0; axis < 3; axis++) {
      out[axis] /= length;
    }
    return length > 0;
  }
}
