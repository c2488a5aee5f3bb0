package org.selectiverenderer.runtime.render.light;

import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * How coarse a mesh is for light at its vertices.
 *
 * @param leastCosine of the angle between the normals at the two ends of an edge
 * @param longestEdge in the mesh's own coordinates
 */
public record MeshSurvey(double leastCosine, double longestEdge) {
  /** Of what is not lit or has no edges to split. */
  static final MeshSurvey FINE = new MeshSurvey(1, 0);

  public static MeshSurvey of(Mesh mesh) {
    float[] normals = mesh.normals();
    if (normals == null || mesh.primitive() != Mesh.Primitive.TRIANGLES) {
      return FINE;
    }
    float[] positions = mesh.positions();
    int[] indices = mesh.indices();
    float cosine = 1;
    float square = 0;
    for (int i = 0; i < indices.length; i += 3) {
      int a = 3 * indices[i];
      int b = 3 * indices[i + 1];
      int c = 3 * indices[i + 2];
      cosine = Math.min(cosine, dot(normals, a, b));
      cosine = Math.min(cosine, dot(normals, b, c));
      cosine = Math.min(cosine, dot(normals, c, a));
      square = Math.max(square, square(positions, a, b));
      square = Math.max(square, square(positions, b, c));
      square = Math.max(square, square(positions, c, a));
    }
    return new MeshSurvey(cosine, Math.sqrt(square));
  }

  private static float dot(float[] v, int a, int b) {
    return v[a] * v[b] + v[a + 1] * v[b + 1] + v[a + 2] * v[b + 2];
  }

  private static float square(float[] p, int a, int b) {
    float x = p[b] - p[a];
    float y = p[b + 1] - p[a + 1];
    float z = p[b + 2] - p[a + 2];
    return x * x + y * y + z * z;
  }
}
