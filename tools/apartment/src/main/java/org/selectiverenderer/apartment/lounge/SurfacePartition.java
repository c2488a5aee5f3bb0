package org.selectiverenderer.apartment.lounge;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * Partitions one surface along its edges into parts of several materials: a label on a bottle,
 * print on a page. The borders share positions, so that no gap opens where the model is reduced and
 * no part lies closely above another.
 */
final class SurfacePartition {

  private SurfacePartition() {}

  /** Returns the triangles whose centroid is chosen. */
  static TriangleMesh where(TriangleMesh mesh, Predicate<Vector3d> chosen) {
    float[] positions = new float[mesh.positions().length];
    int[] triangles = new int[mesh.triangles().length];
    Map<Integer, Integer> known = new HashMap<>();
    int corners = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      if (chosen.test(middle(mesh, t))) {
        for (int k = 0; k < 3; k++) {
          int from = mesh.triangles()[t + k];
          int to = known.computeIfAbsent(from, f -> known.size());
          System.arraycopy(mesh.positions(), 3 * from, positions, 3 * to, 3);
          triangles[corners++] = to;
        }
      }
    }
    return new TriangleMesh(
        Arrays.copyOf(positions, 3 * known.size()), Arrays.copyOf(triangles, corners));
  }

  private static Vector3d middle(TriangleMesh mesh, int t) {
    Vector3d sum = mesh.point(mesh.triangles()[t]);
    sum.add(mesh.point(mesh.triangles()[t + 1])).add(mesh.point(mesh.triangles()[t + 2]));
    return sum.div(3);
  }
}
