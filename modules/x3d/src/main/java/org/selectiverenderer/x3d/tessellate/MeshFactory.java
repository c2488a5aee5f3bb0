package org.selectiverenderer.x3d.tessellate;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.geometry.mesh.VertexWelder;

/** Builds meshes from vertex and index arrays, as other file formats provide them. */
public final class MeshFactory {
  private MeshFactory() {}

  /**
   * Returns the mesh of faces indexed as in an Tessellator.IndexedFaceSetTessellator; invalid faces
   * are left out.
   *
   * @param points x, y, z of each point
   * @param coordIndex the point indices of each face, followed by -1
   * @return a mesh without normals
   */
  public static Mesh faces(float[] points, int[] coordIndex) {
    CoordinatePoints all = CoordinatePoints.of(points);
    IndexStreamRanges runs = IndexStreamRanges.separated(coordIndex);
    TriangleListBuilder triangles = new TriangleListBuilder(coordIndex, coordIndex.length);
    PolygonTriangulator splitter = new PolygonTriangulator(points, triangles);
    FaceValidator check = new FaceValidator(coordIndex, all, 3);
    for (int face = 0; face < runs.count(); face++) {
      if (check.accepts(runs.from(face), runs.to(face))) {
        splitter.split(runs.from(face), runs.to(face), face);
      }
    }
    triangles.dropDegenerate(points);
    return new IndexedMeshBuilder(points, triangles.points(), null, null, null)
        .mesh(Mesh.Primitive.TRIANGLES, false, true);
  }

  /**
   * Returns the mesh of triangles with one index for all attributes. Degenerate triangles are left
   * out. Missing normals are generated as for an Tessellator.IndexedFaceSetTessellator (X3D 4.0,
   * 11.2.3), in which vertices of equal position are one point.
   *
   * @param form the vertex positions, all finite, and the triangles
   * @param normals x, y, z per vertex, of unit length, or null
   * @param colors r, g, b, a per vertex, or null
   * @param texCoords s, t per vertex, or null
   * @param creaseAngle in radians, for generated normals; edges with a smaller angle are smooth
   * @return a mesh with normals
   */
  public static Mesh of(
      TriangleMesh form,
      float @Nullable [] normals,
      float @Nullable [] colors,
      float @Nullable [] texCoords,
      double creaseAngle,
      boolean solid) {
    float[] positions = form.positions();
    int[] triangles = form.triangles();
    VertexWelder points = new VertexWelder(positions.length / 3, positions, null, null, null);
    points.weld();
    float[] xyz = points.compact(positions, 3);
    int[] welded = triangles.clone();
    points.rename(welded);
    TriangleListBuilder list = new TriangleListBuilder(welded, welded.length / 3);
    for (int i = 0; i + 2 < welded.length; i += 3) {
      list.add(i, i + 1, i + 2, i / 3);
    }
    list.dropDegenerate(xyz);
    int[] corners = list.points();
    int[] vertices = new int[corners.length];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = triangles[list.corners()[i]];
    }
    VertexAttribute shaded =
        normals != null
            ? new VertexAttribute(normals, 3, vertices)
            : NormalGenerator.of(xyz, corners, list.faces(), welded.length / 3, creaseAngle);
    return new IndexedMeshBuilder(
            xyz,
            corners,
            shaded,
            colors == null ? null : new VertexAttribute(colors, 4, vertices),
            texCoords == null ? null : new VertexAttribute(texCoords, 2, vertices))
        .mesh(Mesh.Primitive.TRIANGLES, solid, false);
  }
}
