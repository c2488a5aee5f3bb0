package org.selectiverenderer.x3d.tessellate;

import java.util.Arrays;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Removes degenerate triangles, those without area, from a computed mesh. */
final class DegenerateTriangleFilter {
  private DegenerateTriangleFilter() {}

  /** Returns the mesh without degenerate triangles; an empty one if a point is not finite. */
  static Mesh without(Mesh mesh, TessellationContext job) {
    int[] indices = mesh.indices();
    float[] xyz = mesh.positions();
    for (float value : xyz) {
      if (!Float.isFinite(value)) {
        job.problem("has points that are not finite; it is left out");
        return PrimitiveMeshBuilder.empty(mesh.solid());
      }
    }
    int[] kept = new int[indices.length];
    int count = 0;
    for (int i = 0; i < indices.length; i += 3) {
      if (TriangleMath.hasArea(
          xyz, 3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2], 1e-16)) {
        System.arraycopy(indices, i, kept, count, 3);
        count += 3;
      }
    }
    if (count == indices.length) {
      return mesh;
    }
    job.countDegenerate((indices.length - count) / 3);
    int[] left = Arrays.copyOf(kept, count);
    return new Mesh(
        mesh.primitive(),
        xyz,
        mesh.normals(),
        mesh.colors(),
        mesh.texCoords(),
        left,
        mesh.solid(),
        Mesh.boundsOf(xyz, left));
  }
}
