package org.selectiverenderer.browser.collision;

import java.util.Arrays;
import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.bvh.ClosestPoint;

/**
 * The obstacles of a walking body as segments in the horizontal plane: each triangle is clipped to
 * the heights between which the body collides and projected onto y = 0. So steps below those
 * heights, the floor and the ceiling are no obstacles, and a wall stops the body exactly at the
 * collision distance whatever its height.
 */
public final class WallObstacleSet implements ObstacleSet {
  /**
   * Steepest ground that can be walked on: 50 degrees, as the cosine of the angle to the vertical.
   */
  public static final double WALKABLE = Math.cos(Math.toRadians(50));

  private final CandidateTriangles triangles;
  private final Set<PlacedMesh> bumped;
  private double[] ends = new double[4 * 64];
  private int[] sources = new int[64];
  private int size;
  private final Vector3d from = new Vector3d();
  private final Vector3d to = new Vector3d();

  // A triangle cut by two planes has at most five corners.
  private final double[] polygon = new double[3 * 5];
  private final double[] cut = new double[3 * 5];

  /**
   * @param at the body's position; only x and z count
   * @param low the height up to which the body steps over obstacles, or up a slope that it stands
   *     on
   * @param high the height of the body's top
   * @param bumped receives the meshes that stopped the body
   */
  public WallObstacleSet(
      CandidateTriangles triangles, Vector3dc at, double low, double high, Set<PlacedMesh> bumped) {
    this.triangles = triangles;
    this.bumped = bumped;
    Vector3d a = new Vector3d();
    Vector3d b = new Vector3d();
    Vector3d c = new Vector3d();
    for (int triangle = 0; triangle < triangles.size(); triangle++) {
      triangles.corner(triangle, 0, a);
      triangles.corner(triangle, 1, b);
      triangles.corner(triangle, 2, c);
      double lowest = Math.min(a.y, Math.min(b.y, c.y));
      double highest = Math.max(a.y, Math.max(b.y, c.y));
      if (highest >= low && lowest <= high && !ground(a, b, c, at, low)) {
        add(triangle, a, b, c, low, high);
      }
    }
  }

  /** Returns whether a triangle is a walkable slope that starts under the body. */
  private static boolean ground(Vector3dc a, Vector3dc b, Vector3dc c, Vector3dc at, double low) {
    Vector3d normal = b.sub(a, new Vector3d()).cross(c.sub(a, new Vector3d())).normalize();
    if (!(Math.abs(normal.y) >= WALKABLE)) {
      return false;
    }
    double height = a.y() - (normal.x * (at.x() - a.x()) + normal.z * (at.z() - a.z())) / normal.y;
    return height <= low;
  }

  private void add(int triangle, Vector3dc a, Vector3dc b, Vector3dc c, double low, double high) {
    put(polygon, 0, a);
    put(polygon, 1, b);
    put(polygon, 2, c);
    int corners = cut(polygon, 3, cut, low, 1);
    corners = cut(cut, corners, polygon, high, -1);
    for (int i = 0; i < corners; i++) {
      int j = (i + 1) % corners;
      addSegment(triangle, polygon[3 * i], polygon[3 * i + 2], polygon[3 * j], polygon[3 * j + 2]);
    }
  }

  private static void put(double[] target, int corner, Vector3dc p) {
    target[3 * corner] = p.x();
    target[3 * corner + 1] = p.y();
    target[3 * corner + 2] = p.z();
  }

  /** Clips a polygon to one side of a height (Sutherland and Hodgman 1974). */
  private static int cut(double[] in, int corners, double[] out, double height, int side) {
    int kept = 0;
    for (int i = 0; i < corners; i++) {
      int j = (i + 1) % corners;
      double here = side * (in[3 * i + 1] - height);
      double there = side * (in[3 * j + 1] - height);
      if (here >= 0) {
        System.arraycopy(in, 3 * i, out, 3 * kept++, 3);
      }
      if (here < 0 != there < 0) {
        double t = here / (here - there);
        out[3 * kept] = in[3 * i] + t * (in[3 * j] - in[3 * i]);
        out[3 * kept + 1] = height;
        out[3 * kept + 2] = in[3 * i + 2] + t * (in[3 * j + 2] - in[3 * i + 2]);
        kept++;
      }
    }
    return kept;
  }

  private void addSegment(int triangle, double x0, double z0, double x1, double z1) {
    if (size == sources.length) {
      ends = Arrays.copyOf(ends, 2 * ends.length);
      sources = Arrays.copyOf(sources, 2 * size);
    }
    ends[4 * size] = x0;
    ends[4 * size + 1] = z0;
    ends[4 * size + 2] = x1;
    ends[4 * size + 3] = z1;
    sources[size++] = triangle;
  }

  @Override
  public int size() {
    return size;
  }

  @Override
  public void nearest(int piece, Vector3dc p, Vector3d out) {
    from.set(ends[4 * piece], p.y(), ends[4 * piece + 1]);
    to.set(ends[4 * piece + 2], p.y(), ends[4 * piece + 3]);
    ClosestPoint.onSegment(from, to, p, out);
  }

  @Override
  public boolean crossed(int piece, Vector3dc begin, Vector3dc end) {
    double x0 = ends[4 * piece];
    double z0 = ends[4 * piece + 1];
    double x1 = ends[4 * piece + 2];
    double z1 = ends[4 * piece + 3];
    double beginSide = side(x0, z0, x1, z1, begin.x(), begin.z());
    double endSide = side(x0, z0, x1, z1, end.x(), end.z());
    if (beginSide == endSide || beginSide * endSide > 0) {
      return false;
    }
    double near = side(begin.x(), begin.z(), end.x(), end.z(), x0, z0);
    double far = side(begin.x(), begin.z(), end.x(), end.z(), x1, z1);
    return near * far <= 0;
  }

  /** Returns twice the signed area of the triangle of the three points; its sign tells the side. */
  private static double side(double x0, double z0, double x1, double z1, double x, double z) {
    return (x1 - x0) * (z - z0) - (z1 - z0) * (x - x0);
  }

  @Override
  public void touched(int piece) {
    bumped.add(triangles.owner(sources[piece]));
  }
}
