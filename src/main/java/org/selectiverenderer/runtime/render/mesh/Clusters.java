package org.selectiverenderer.runtime.render.mesh;

/**
 * Neighbouring triangles of a mesh that are kept or culled together, in local coordinates.
 *
 * @param firstIndex where each cluster's indices begin in the index buffer, and the end of the last
 * @param spheres bounding spheres: centre x, y, z, radius
 * @param cones what the triangles' front sides face: axis x, y, z, and the sine of the half angle;
 *     the sine is 1 where they face too many ways to be culled together
 */
public record Clusters(int[] firstIndex, float[] spheres, float[] cones) {
  public int size() {
    return firstIndex.length - 1;
  }

  /** One cluster that is never culled by itself. */
  static Clusters whole(int indexCount) {
    return new Clusters(
        new int[] {0, indexCount},
        new float[] {0, 0, 0, Float.POSITIVE_INFINITY},
        new float[] {0, 0, 1, 1});
  }

  /** The same clusters in an index buffer in which they begin elsewhere. */
  Clusters from(int index) {
    int[] moved = firstIndex.clone();
    for (int i = 0; i < moved.length; i++) {
      moved[i] += index - firstIndex[0];
    }
    return new Clusters(moved, spheres, cones);
  }

  /** The number of indices in all of them. */
  public int indexCount() {
    return firstIndex[size()] - firstIndex[0];
  }

  /**
   * Whether every triangle of a cluster turns its front to the eye; as {@link #facesAway}, from the
   * other side.
   *
   * @param x the eye in local coordinates
   */
  public boolean facesTowards(int cluster, double x, double y, double z) {
    return turned(cluster, x, y, z, -1);
  }

  /**
   * Whether every triangle of a cluster turns its back to the eye: the eye lies behind all the
   * planes that touch a cone of normals around the bounding sphere. (The test of the direction to
   * the centre, widened by the radius, is the one that Shirman and Abi-Ezzi 1993 call a cone of
   * normals.)
   *
   * @param x the eye in local coordinates
   */
  public boolean facesAway(int cluster, double x, double y, double z) {
    return turned(cluster, x, y, z, 1);
  }

  private boolean turned(int cluster, double x, double y, double z, int sign) {
    int i = 4 * cluster;
    double dx = spheres[i] - x;
    double dy = spheres[i + 1] - y;
    double dz = spheres[i + 2] - z;
    double along = sign * (dx * cones[i] + dy * cones[i + 1] + dz * cones[i + 2]);
    return along - spheres[i + 3] > 0
        && along - spheres[i + 3] >= cones[i + 3] * Math.sqrt(dx * dx + dy * dy + dz * dz);
  }
}
