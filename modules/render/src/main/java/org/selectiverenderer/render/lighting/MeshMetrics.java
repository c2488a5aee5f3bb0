package org.selectiverenderer.render.lighting;

import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Metrics of how coarse a mesh is for per-vertex lighting, in its own coordinates.
 *
 * @param longest the length of the longest edge
 * @param largest the size of the largest triangle: twice the height of a narrow one, else its
 *     longest edge
 * @param bent the size of the largest triangle whose normals differ by more than {@link
 *     CurvatureTolerance#WIDE}
 * @param bentLittle the size of the largest triangle whose normals differ by more than {@link
 *     CurvatureTolerance#NARROW}
 */
public record MeshMetrics(double longest, double largest, double bent, double bentLittle) {
  /** The metrics of a mesh that is not lit or has no edges to split. */
  static final MeshMetrics FINE = new MeshMetrics(0, 0, 0, 0);

  static MeshMetrics of(Mesh mesh) {
    float[] normals = mesh.normals();
    if (normals == null || mesh.primitive() != Mesh.Primitive.TRIANGLES) {
      return FINE;
    }
    float[] p = mesh.positions();
    int[] indices = mesh.indices();
    double longest = 0;
    double largest = 0;
    double bent = 0;
    double bentLittle = 0;
    for (int i = 0; i < indices.length; i += 3) {
      int a = 3 * indices[i];
      int b = 3 * indices[i + 1];
      int c = 3 * indices[i + 2];
      float ab = square(p, a, b);
      float bc = square(p, b, c);
      float ca = square(p, c, a);
      longest = greater(longest, greater(ab, greater(bc, ca)));
      float cosine = less(dot(normals, a, b), less(dot(normals, b, c), dot(normals, c, a)));
      double size = size(ab, bc, ca);
      largest = greater(largest, size);
      bent = cosine < CurvatureTolerance.WIDE ? greater(bent, size) : bent;
      bentLittle = cosine < CurvatureTolerance.NARROW ? greater(bentLittle, size) : bentLittle;
    }
    return new MeshMetrics(
        Math.sqrt(longest), Math.sqrt(largest), Math.sqrt(bent), Math.sqrt(bentLittle));
  }

  /**
   * Returns the square of a triangle's size from the squares of its edges (Heron's formula): of its
   * longest edge or of twice the height above that, whichever is less.
   */
  static double size(double ab, double bc, double ca) {
    double longest = greater(ab, greater(bc, ca));
    double area = 2 * (ab * bc + bc * ca + ca * ab) - ab * ab - bc * bc - ca * ca; // 16 * area^2
    return longest > 0 ? Math.min(longest, area / longest) : 0;
  }

  /** Returns the size of the largest triangle whose normals differ by more than a limit. */
  double bent(double cosine) {
    return cosine >= CurvatureTolerance.NARROW ? bentLittle : bent;
  }

  // Plain comparisons instead of Math.max and Math.min, whose handling of NaN and the sign of zero
  // would take longer than all the rest.
  private static double greater(double a, double b) {
    return b > a ? b : a;
  }

  private static float less(float a, float b) {
    return b < a ? b : a;
  }

  private static float dot(float[] n, int a, int b) {
    return n[a] * n[b] + n[a + 1] * n[b + 1] + n[a + 2] * n[b + 2];
  }

  private static float square(float[] p, int a, int b) {
    float x = p[b] - p[a];
    float y = p[b + 1] - p[a + 1];
    float z = p[b + 2] - p[a + 2];
    return x * x + y * y + z * z;
  }
}
