package org.selectiverenderer.modelling;

import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/**
 * Builds extruded solids with a flat front and back: an outline in the xy plane, with or without
 * holes, extruded along z. The back is at z = 0 and the front, which shows the outline as drawn, at
 * z = depth.
 *
 * <p>An outline of n points in all with h holes gives {@code 2 (n - 2 + 2 h)} triangles in the caps
 * and {@code 2 n} per band of the walls.
 */
public final class ExtrudedSolid {

  private ExtrudedSolid() {}

  /** Returns an extrusion with sharp edges. */
  public static TriangleMesh plain(double depth, SimplePolygon outline, SimplePolygon... holes) {
    return build(depth, 0, 0, outline, holes);
  }

  /**
   * Returns an extrusion with rounded edges at front and back.
   *
   * @param bevel bevel radius, metres; at most half the depth, and smaller than the narrowest part
   *     of the outline allows
   * @param steps number of segments of the bevel, 1 is a chamfer; each is one more band at front
   *     and back
   */
  public static TriangleMesh bevelled(
      double depth, double bevel, int steps, SimplePolygon outline, SimplePolygon... holes) {
    return build(depth, bevel, steps, outline, holes);
  }

  /**
   * Returns a horizontal plate with rounded edges: the outline seen from above (y away from the
   * viewer, towards -z), from y = 0 to y = thickness.
   */
  public static TriangleMesh plate(
      double thickness, double bevel, int steps, SimplePolygon outline, SimplePolygon... holes) {
    return build(thickness, bevel, steps, outline, holes).turnX(-90);
  }

  /**
   * Returns the front cap alone: a flat surface in the plane z = 0 that shows the outline as drawn;
   * {@code n - 2 + 2 h} triangles, with a border.
   */
  public static TriangleMesh face(SimplePolygon outline, SimplePolygon... holes) {
    double[][] rings = rings(outline, holes);
    TriangleMeshBuilder mesh = new TriangleMeshBuilder();
    for (double[] ring : rings) {
      for (int i = 0; i < ring.length; i += 2) {
        mesh.point(ring[i], ring[i + 1], 0);
      }
    }
    EarClippingTriangulator.fill(rings, 0, mesh);
    return mesh.mesh();
  }

  private static double[][] rings(SimplePolygon outline, SimplePolygon... holes) {
    double[][] rings = new double[holes.length + 1][];
    rings[0] = outline.points();
    for (int i = 0; i < holes.length; i++) {
      rings[i + 1] = holes[i].clockwise();
    }
    return rings;
  }

  private static TriangleMesh build(
      double depth, double bevel, int steps, SimplePolygon outline, SimplePolygon... holes) {
    if (2 * bevel > depth + 1e-9) {
      throw new IllegalArgumentException("the bevel radius must be at most half the depth");
    }
    double[][] rings = rings(outline, holes);
    TriangleMeshBuilder mesh = new TriangleMeshBuilder();
    int perLevel = 0;
    for (double[] ring : rings) {
      perLevel += ring.length / 2;
    }
    int bands = steps > 0 && bevel > 0 ? steps : 0;
    boolean middle = depth - 2 * bevel > 1e-9 || bands == 0;
    int levels = 2 * bands + (middle ? 2 : 1);
    double[][] end = rings;
    for (int level = 0; level < levels; level++) {
      boolean front = level > bands;
      int step = front ? levels - 1 - level : level;
      double angle = bands == 0 ? 90 : 90.0 * step / bands;
      double inset = bands == 0 ? 0 : bevel * (1 - DegreeMath.sin(angle));
      double z = bands == 0 ? 0 : bevel * (1 - DegreeMath.cos(angle));
      double[][] moved = inset(rings, inset);
      if (level == 0) {
        end = moved;
      }
      for (double[] ring : moved) {
        for (int i = 0; i < ring.length; i += 2) {
          mesh.point(ring[i], ring[i + 1], front ? depth - z : z);
        }
      }
    }
    for (int level = 0; level + 1 < levels; level++) {
      walls(mesh, rings, level * perLevel, perLevel);
    }
    fill(mesh, end, (levels - 1) * perLevel);
    return mesh.mesh();
  }

  private static double[][] inset(double[][] rings, double distance) {
    double[][] moved = new double[rings.length][];
    for (int i = 0; i < rings.length; i++) {
      moved[i] = distance == 0 ? rings[i] : PolygonOffset.inset(rings[i], distance);
    }
    return moved;
  }

  private static void walls(TriangleMeshBuilder mesh, double[][] rings, int first, int perLevel) {
    int at = first;
    for (double[] ring : rings) {
      int n = ring.length / 2;
      for (int i = 0; i < n; i++) {
        int a = at + i;
        int b = at + (i + 1) % n;
        mesh.quad(a, b, b + perLevel, a + perLevel);
      }
      at += n;
    }
  }

  /** Triangulates the front and back caps; the back's points are the mesh's first. */
  private static void fill(TriangleMeshBuilder mesh, double[][] end, int front) {
    TriangleMeshBuilder flat = new TriangleMeshBuilder();
    EarClippingTriangulator.fill(end, 0, flat);
    int[] triangles = flat.mesh().triangles();
    for (int t = 0; t < triangles.length; t += 3) {
      int a = triangles[t];
      int b = triangles[t + 1];
      int c = triangles[t + 2];
      mesh.triangle(front + a, front + b, front + c);
      mesh.triangle(a, c, b);
    }
  }
}
