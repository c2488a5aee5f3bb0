package org.selectiverenderer.browser.collision;

import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.bvh.ClosestPoint;

/** The triangles near the viewer as obstacles in space, for a viewer who flies. */
public final class TriangleObstacleSet implements ObstacleSet {
  private final CandidateTriangles triangles;
  private final Set<PlacedMesh> bumped;
  private final Vector3d a = new Vector3d();
  private final Vector3d b = new Vector3d();
  private final Vector3d c = new Vector3d();

  /**
   * @param bumped receives the meshes that stopped the viewer
   */
  public TriangleObstacleSet(CandidateTriangles triangles, Set<PlacedMesh> bumped) {
    this.triangles = triangles;
    this.bumped = bumped;
  }

  @Override
  public int size() {
    return triangles.size();
  }

  private void load(int piece) {
    triangles.corner(piece, 0, a);
    triangles.corner(piece, 1, b);
    triangles.corner(piece, 2, c);
  }

  @Override
  public void nearest(int piece, Vector3dc p, Vector3d out) {
    load(piece);
    ClosestPoint.onTriangle(a, b, c, p, out);
  }

  @Override
  public boolean crossed(int piece, Vector3dc from, Vector3dc to) {
    load(piece);
    Vector3d direction = to.sub(from, new Vector3d());
    Vector3d normal = b.sub(a, new Vector3d()).cross(c.sub(a, new Vector3d()));
    double before = from.sub(a, new Vector3d()).dot(normal);
    double after = to.sub(a, new Vector3d()).dot(normal);
    if (before == after || before * after > 0) {
      return false;
    }
    Vector3d at = new Vector3d(from).fma(before / (before - after), direction);
    Vector3d closest = new Vector3d();
    ClosestPoint.onTriangle(a, b, c, at, closest);
    double size = Math.sqrt(Math.max(a.distanceSquared(b), a.distanceSquared(c)));
    return closest.distance(at) <= 1e-9 * size;
  }

  @Override
  public void touched(int piece) {
    bumped.add(triangles.owner(piece));
  }
}
