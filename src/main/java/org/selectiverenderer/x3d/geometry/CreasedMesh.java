package org.selectiverenderer.x3d.geometry;

/** Meshes of bare points and triangles, as programs make them rather than files. */
public final class CreasedMesh {
  private CreasedMesh() {}

  /**
   * The mesh that a browser makes of an IndexedFaceSet with these triangles and no normals (X3D
   * 4.0, 11.2.3). Triangles without area are left out; equal points count as one.
   *
   * @param positions x, y, z per point, all finite
   * @param triangles three points each, counter-clockwise seen from outside
   * @param creaseAngle radians; edges of faces that meet at less are smooth
   * @return a mesh with normals, without colours and texture coordinates
   */
  public static Mesh of(float[] positions, int[] triangles, double creaseAngle, boolean solid) {
    ValueWelder points = new ValueWelder(positions.length / 3, positions, null, null, null);
    points.weld();
    float[] xyz = points.compact(positions, 3);
    int[] welded = triangles.clone();
    points.rename(welded);
    TriangleList list = new TriangleList(welded, welded.length / 3);
    for (int i = 0; i + 2 < welded.length; i += 3) {
      list.add(i, i + 1, i + 2, i / 3);
    }
    list.dropDegenerate(xyz);
    int[] corners = list.points();
    Attribute normals =
        GeneratedNormals.of(xyz, corners, list.faces(), welded.length / 3, creaseAngle);
    return new Welder(xyz, corners, normals, null, null)
        .mesh(Mesh.Primitive.TRIANGLES, solid, false);
  }
}
