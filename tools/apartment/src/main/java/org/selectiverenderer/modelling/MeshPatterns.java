package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Repeats a mesh in a linear, circular or mirrored pattern. */
public final class MeshPatterns {

  private MeshPatterns() {}

  /** Returns {@code count} copies in a row, each moved by the vector from the one before. */
  public static TriangleMesh row(TriangleMesh mesh, int count, double x, double y, double z) {
    List<TriangleMesh> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(mesh.move(i * x, i * y, i * z));
    }
    return TriangleMesh.of(all);
  }

  /** Returns {@code count} copies rotated in equal steps about the y axis. */
  public static TriangleMesh around(TriangleMesh mesh, int count) {
    List<TriangleMesh> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(mesh.turnY(360.0 * i / count));
    }
    return TriangleMesh.of(all);
  }

  /** Returns the mesh and its mirror image in the plane x = 0. */
  public static TriangleMesh bothSides(TriangleMesh mesh) {
    return mesh.append(mesh.mirrorX());
  }

  /**
   * Returns four mirrored copies at (x, z), (-x, z), (x, -z), (-x, -z), as the legs of a table are.
   */
  public static TriangleMesh corners(TriangleMesh mesh, double x, double z) {
    TriangleMesh right = mesh.move(x, 0, z);
    return bothSides(right.append(right.mirrorZ()));
  }
}
