package org.selectiverenderer.modelling;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.TriangleMeshBuilder;

/** Welds vertices at the same position. */
public final class VertexWelding {

  private VertexWelding() {}

  private record Cell(long x, long y, long z) {}

  /**
   * Welds points that agree to a tenth of a micrometre, and drops the triangles that become
   * degenerate.
   */
  public static TriangleMesh weld(TriangleMesh mesh) {
    return weld(mesh, 1e-7);
  }

  /**
   * Welds points that fall into one cell of a grid, and drops the triangles that become degenerate.
   *
   * @param cell size of the grid's cells, metres
   */
  public static TriangleMesh weld(TriangleMesh mesh, double cell) {
    TriangleMeshBuilder out = new TriangleMeshBuilder();
    Map<Cell, Integer> known = new HashMap<>();
    int[] target = new int[mesh.pointCount()];
    for (int i = 0; i < target.length; i++) {
      float x = mesh.positions()[3 * i];
      float y = mesh.positions()[3 * i + 1];
      float z = mesh.positions()[3 * i + 2];
      Cell place = new Cell(Math.round(x / cell), Math.round(y / cell), Math.round(z / cell));
      target[i] = known.computeIfAbsent(place, p -> out.point(x, y, z));
    }
    int[] t = mesh.triangles();
    for (int i = 0; i < t.length; i += 3) {
      int a = target[t[i]];
      int b = target[t[i + 1]];
      int c = target[t[i + 2]];
      if (a != b && b != c && c != a) {
        out.triangle(a, b, c);
      }
    }
    return out.mesh();
  }
}
