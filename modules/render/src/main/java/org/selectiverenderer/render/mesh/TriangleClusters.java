package org.selectiverenderer.render.mesh;

/**
 * The triangle clusters of a mesh: neighbouring triangles that are kept or culled together. In
 * local coordinates.
 *
 * @param firstIndex the first index of each cluster in the index buffer, and the end of the last
 *     cluster
 * @param spheres bounding spheres: centre x, y, z, radius
 * @param cones normal cones: axis x, y, z and the sine of the half angle; the sine is 1 where the
 *     normals spread too widely for the cluster to be culled by its facing
 */
public record TriangleClusters(int[] firstIndex, float[] spheres, float[] cones) {
  public int size() {
    return firstIndex.length - 1;
  }

  /** Returns one cluster that is never culled by itself. */
  static TriangleClusters whole(int indexCount) {
    return new TriangleClusters(
        new int[] {0, indexCount},
        new float[] {0, 0, 0, Float.POSITIVE_INFINITY},
        new float[] {0, 0, 1, 1});
  }

  /** Returns the same clusters moved to another first index of the index buffer. */
  TriangleClusters from(int index) {
    int[] moved = firstIndex.clone();
    for (int i = 0; i < moved.length; i++) {
      moved[i] += index - firstIndex[0];
    }
    return new TriangleClusters(moved, spheres, cones);
  }

  /** Returns the number of indices in all clusters. */
  public int indexCount() {
    return firstIndex[size()] - firstIndex[0];
  }

  /**
   * Returns whether every triangle of a cluster faces the eye with its front side; tested like
   * {@link #facesAway}, from the other side.
   *
   * @param x the eye in local coordinates
   */
  public boolean facesTowards(int cluster, double x, double y, double z) {
    return turned(cluster, x, y, z, -1);
  }

  /**
   * Returns whether every triangle of a cluster faces away from the eye: the eye lies behind all
   * planes that are perpendicular to a normal of the cone and touch the bounding sphere (the cone
   * of normals technique of Shirman and Abi-Ezzi 1993: the direction to the centre is tested,
   * widened by the radius).
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
