package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;

/** Tessellates Box nodes (X3D 4.0, 13.3.1): 12 triangles; each face shows the whole texture. */
final class BoxTessellator {
  /** For each face its normal, the direction of S, and the direction of T. */
  private static final int[][] FACES = {
    {0, 0, 1, 1, 0, 0, 0, 1, 0},
    {0, 0, -1, -1, 0, 0, 0, 1, 0},
    {1, 0, 0, 0, 0, -1, 0, 1, 0},
    {-1, 0, 0, 0, 0, 1, 0, 1, 0},
    {0, 1, 0, 1, 0, 0, 0, 0, -1},
    {0, -1, 0, 1, 0, 0, 0, 0, 1},
  };

  private BoxTessellator() {}

  static Mesh mesh(TessellationContext job) {
    boolean solid = job.node().bool("solid");
    PrimitiveMeshBuilder builder = new PrimitiveMeshBuilder();
    if (!job.positive("size")) {
      return builder.mesh(solid);
    }
    float[] size = job.node().floats("size");
    for (int[] face : FACES) {
      int a = corner(builder, size, face, 0, 0);
      int b = corner(builder, size, face, 1, 0);
      int c = corner(builder, size, face, 1, 1);
      int d = corner(builder, size, face, 0, 1);
      builder.quad(a, b, c, d);
    }
    return builder.mesh(solid);
  }

  private static int corner(PrimitiveMeshBuilder builder, float[] size, int[] face, int s, int t) {
    double[] at = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      int side = face[axis] + face[3 + axis] * (2 * s - 1) + face[6 + axis] * (2 * t - 1);
      at[axis] = side * 0.5 * size[axis];
    }
    return builder.vertex(at[0], at[1], at[2], face[0], face[1], face[2], s, t);
  }
}
