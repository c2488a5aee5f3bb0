package org.selectiverenderer.geometry.bvh;

import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Tests whether a point is inside a closed mesh or on its surface by ray casting: most of three
 * rays must cross the surface an odd number of times. An open mesh, such as ground, has only its
 * surface.
 */
public final class PointInMesh {
  /** Ray directions that are not parallel to usual model axes, so that rays hit few edges. */
  private static final Vector3dc[] SIDES = {
    new Vector3d(0.953, 0.214, 0.127),
    new Vector3d(0.171, 0.967, 0.119),
    new Vector3d(0.137, 0.191, 0.943)
  };

  /** The maximum number of crossings counted per ray. */
  private static final int MOST = 10_000;

  private PointInMesh() {}

  /**
   * Returns whether a point is inside a mesh or on its surface.
   *
   * @param point a point in the mesh's coordinates
   * @param touching the distance up to which a point is on the surface
   */
  public static boolean contains(MeshBvh mesh, Vector3dc point, double touching) {
    if (touches(mesh, point, touching)) {
      return true;
    }
    int odd = 0;
    for (Vector3dc side : SIDES) {
      odd += passed(mesh, point, side) % 2;
    }
    return odd >= 2;
  }

  private static boolean touches(MeshBvh mesh, Vector3dc p, double touching) {
    boolean[] found = new boolean[1];
    Vector3d a = new Vector3d();
    Vector3d b = new Vector3d();
    Vector3d c = new Vector3d();
    Vector3d nearest = new Vector3d();
    mesh.inBox(
        new double[] {
          p.x() - touching,
          p.y() - touching,
          p.z() - touching,
          p.x() + touching,
          p.y() + touching,
          p.z() + touching
        },
        triangle -> {
          ClosestPoint.onTriangle(
              mesh.corner(triangle, 0, a),
              mesh.corner(triangle, 1, b),
              mesh.corner(triangle, 2, c),
              p,
              nearest);
          found[0] |= nearest.distance(p) <= touching;
        });
    return found[0];
  }

  private static int passed(MeshBvh mesh, Vector3dc point, Vector3dc side) {
    int passed = 0;
    double from = 0;
    while (passed < MOST) {
      Vector3d start = new Vector3d(point).fma(from, side);
      Optional<MeshBvh.MeshHit> hit =
          mesh.nearest(start, side, Double.POSITIVE_INFINITY, MeshBvh.Sides.BOTH);
      if (hit.isEmpty()) {
        return passed;
      }
      passed++;
      from += hit.get().distance() + 1e-9 * (1 + from + hit.get().distance());
    }
    return passed;
  }
}
