package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/** Repetitions of a mesh. */
public final class Copies {

  private Copies() {}

  /** {@code count} of them, each moved on from the one before. */
  public static TriangleMesh row(TriangleMesh mesh, int count, double x, double y, double z) {
    List<TriangleMesh> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(mesh.move(i * x, i * y, i * z));
    }
    return TriangleMesh.of(all);
  }

  /** {@code count} of them in equal steps about the y axis. */
  public static TriangleMesh around(TriangleMesh mesh, int count) {
    List<TriangleMesh> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(mesh.turnY(360.0 * i / count));
    }
    return TriangleMesh.of(all);
  }

  /** The mesh and its mirror image at x = 0. */
  public static TriangleMesh bothSides(TriangleMesh mesh) {
    return mesh.append(mesh.mirrorX());
  }

  /** Four of them: at (x, z), (-x, z), (x, -z), (-x, -z), mirrored, as legs are. */
  public static TriangleMesh corners(TriangleMesh mesh, double x, double z) {
    TriangleMesh right = mesh.move(x, 0, z);
    return bothSides(right.append(right.mirrorZ()));
  }
}
