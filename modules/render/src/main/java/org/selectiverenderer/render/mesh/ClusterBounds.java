package org.selectiverenderer.render.mesh;

import org.selectiverenderer.geometry.TriangleMath;

/** Computes the bounding sphere and the normal cone of each triangle cluster. */
final class ClusterBounds {
  /** The cosine of the widest half angle (about 84 degrees); wider cones are hardly ever culled. */
  private static final double NARROWEST_DOT = 0.1;

  private final float[] positions;
  private final int[] indices;

  /** Unit normals of the triangles of a cluster, x, y, z each; zero for one without area. */
  private double[] normals = {};

  private final double[] normal = new double[3];

  /**
   * @param indices three per triangle, ordered by cluster
   */
  ClusterBounds(float[] positions, int[] indices) {
    this.positions = positions;
    this.indices = indices;
  }

  /**
   * @param ends the end of each cluster, counted in triangles
   */
  TriangleClusters of(int[] ends) {
    int[] first = new int[ends.length + 1];
    float[] spheres = new float[4 * ends.length];
    float[] cones = new float[4 * ends.length];
    for (int c = 0; c < ends.length; c++) {
      first[c + 1] = 3 * ends[c];
      sphere(first[c], first[c + 1], spheres, 4 * c);
      cone(first[c], first[c + 1], cones, 4 * c);
    }
    return new TriangleClusters(first, spheres, cones);
  }

  /**
   * Computes the sphere around the centre of the bounding box: at most a factor of 1.7 too large,
   * and cheap.
   */
  private void sphere(int from, int to, float[] out, int at) {
    double radius = 0;
    for (int axis = 0; axis < 3; axis++) {
      float min = Float.POSITIVE_INFINITY;
      float max = Float.NEGATIVE_INFINITY;
      for (int i = from; i < to; i++) {
        float value = positions[3 * indices[i] + axis];
        min = value < min ? value : min;
        max = value > max ? value : max;
      }
      out[at + axis] = (min + max) / 2;
    }
    for (int i = from; i < to; i++) {
      int v = 3 * indices[i];
      double dx = positions[v] - out[at];
      double dy = positions[v + 1] - out[at + 1];
      double dz = positions[v + 2] - out[at + 2];
      double squared = dx * dx + dy * dy + dz * dz;
      radius = squared > radius ? squared : radius;
    }
    out[at + 3] = Math.nextUp((float) (Math.sqrt(radius) * (1 + 1e-6)));
  }

  private void cone(int from, int to, float[] out, int at) {
    normals(from, to);
    double x = 0;
    double y = 0;
    double z = 0;
    for (int i = 0; i < to - from; i += 3) {
      x += normals[i];
      y += normals[i + 1];
      z += normals[i + 2];
    }
    double length = Math.sqrt(x * x + y * y + z * z);
    double least = length > 0 ? 1 : -1;
    for (int i = 0; i < to - from && length > 0; i += 3) {
      boolean area = normals[i] != 0 || normals[i + 1] != 0 || normals[i + 2] != 0;
      double dot = (x * normals[i] + y * normals[i + 1] + z * normals[i + 2]) / length;
      least = area && dot < least ? dot : least;
    }
    out[at] = length > 0 ? (float) (x / length) : 0;
    out[at + 1] = length > 0 ? (float) (y / length) : 0;
    out[at + 2] = length > 0 ? (float) (z / length) : 0;
    out[at + 3] =
        least <= NARROWEST_DOT ? 1 : (float) Math.min(1, Math.sqrt(1 - least * least) + 1e-4);
  }

  private void normals(int from, int to) {
    if (normals.length < to - from) {
      normals = new double[to - from];
    }
    for (int i = from; i < to; i += 3) {
      TriangleMath.normal(
          positions, 3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2], normal);
      TriangleMath.normalize(normal);
      normals[i - from] = normal[0];
      normals[i - from + 1] = normal[1];
      normals[i - from + 2] = normal[2];
    }
  }
}
