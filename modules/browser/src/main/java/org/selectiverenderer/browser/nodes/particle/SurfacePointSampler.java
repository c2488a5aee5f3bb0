package org.selectiverenderer.browser.nodes.particle;

import java.util.Arrays;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Samples random points uniformly on the surface of a mesh, or inside it. */
final class SurfacePointSampler {
  private static final int TRIES = 24;
  private static final int MAX_CROSSINGS = 64;

  private final Mesh mesh;
  private final double[] areas;
  private final MeshBvh tree;

  private SurfacePointSampler(Mesh mesh, double[] areas) {
    this.mesh = mesh;
    this.areas = areas;
    this.tree = new MeshBvh(mesh);
  }

  /** Makes a sampler; empty for a mesh without area. */
  static Optional<SurfacePointSampler> of(Mesh mesh) {
    if (mesh.primitive() != Mesh.Primitive.TRIANGLES || mesh.isEmpty()) {
      return Optional.empty();
    }
    double[] areas = new double[mesh.polygons()];
    double sum = 0;
    for (int t = 0; t < areas.length; t++) {
      Vector3d a = corner(mesh, t, 0);
      Vector3d b = corner(mesh, t, 1).sub(a);
      Vector3d c = corner(mesh, t, 2).sub(a);
      sum += b.cross(c).length() / 2;
      areas[t] = sum;
    }
    return sum > 0 && Double.isFinite(sum)
        ? Optional.of(new SurfacePointSampler(mesh, areas))
        : Optional.empty();
  }

  private static Vector3d corner(Mesh mesh, int triangle, int corner) {
    int at = 3 * mesh.indices()[3 * triangle + corner];
    float[] p = mesh.positions();
    return new Vector3d(p[at], p[at + 1], p[at + 2]);
  }

  /** Returns the index of the first of ascending sums that is above a value. */
  static int find(double[] sums, double value) {
    int found = Arrays.binarySearch(sums, value);
    return Math.min(found >= 0 ? found : -found - 1, sums.length - 1);
  }

  /**
   * Samples a point on the surface.
   *
   * @param normal receives the normal of its triangle
   */
  void pick(ParticleRandom chance, Vector3d position, Vector3d normal) {
    int triangle = find(areas, chance.part() * areas[areas.length - 1]);
    double u = Math.sqrt(chance.part());
    double v = chance.part();
    Vector3d a = corner(mesh, triangle, 0);
    Vector3d b = corner(mesh, triangle, 1);
    Vector3d c = corner(mesh, triangle, 2);
    position.set(0).fma(1 - u, a).fma(u * (1 - v), b).fma(u * v, c);
    normal.set(b.sub(a).cross(c.sub(a)));
    if (normal.lengthSquared() > 0) {
      normal.normalize();
    }
  }

  /** Returns the BVH of the mesh, for ray casting. */
  MeshBvh tree() {
    return tree;
  }

  /** Samples a point inside a closed surface; on it if the surface encloses hardly any volume. */
  void pickInside(ParticleRandom chance, Vector3d position) {
    float[] box = mesh.bounds();
    for (int i = 0; i < TRIES; i++) {
      position.set(
          chance.between(box[0], box[3]),
          chance.between(box[1], box[4]),
          chance.between(box[2], box[5]));
      if (inside(position)) {
        return;
      }
    }
    pick(chance, position, new Vector3d());
  }

  private boolean inside(Vector3d at) {
    Vector3d from = new Vector3d(at);
    Vector3d way = new Vector3d(0.577, 0.579, 0.576); // Not along an axis, to miss edges.
    boolean inside = false;
    for (int crossings = 0; crossings < MAX_CROSSINGS; crossings++) {
      Optional<MeshBvh.MeshHit> hit =
          tree.nearest(from, way, Double.POSITIVE_INFINITY, MeshBvh.Sides.BOTH);
      if (hit.isEmpty()) {
        break;
      }
      inside = !inside;
      from.fma(hit.get().distance() + 1e-6, way);
    }
    return inside;
  }
}
