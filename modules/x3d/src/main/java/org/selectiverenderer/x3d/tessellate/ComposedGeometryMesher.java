package org.selectiverenderer.x3d.tessellate;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Assembles a mesh from triangulated faces and per-vertex or per-face attributes. */
final class ComposedGeometryMesher {
  /** The index streams of a node for each property; an empty one stands for coordIndex. */
  record Indices(int[] color, int[] normal, int[] texCoord) {
    static final Indices NONE = new Indices(new int[0], new int[0], new int[0]);
  }

  private final TessellationContext job;
  private final CoordinatePoints points;
  private final TriangleListBuilder triangles;
  private final int faceCount;
  private final int[] corners;

  /**
   * Reverses the triangles if the node's {@code ccw} is FALSE, and removes degenerate ones.
   *
   * @param triangles the triangles, whose points are in range and finite
   * @param faceCount a number above all face indices of the triangles
   */
  ComposedGeometryMesher(
      TessellationContext job,
      CoordinatePoints points,
      TriangleListBuilder triangles,
      int faceCount) {
    this.job = job;
    this.points = points;
    this.triangles = triangles;
    this.faceCount = faceCount;
    if (!job.node().bool("ccw")) {
      triangles.reverse();
    }
    job.countDegenerate(triangles.dropDegenerate(points.xyz()));
    this.corners = triangles.points();
  }

  /**
   * Returns the mesh of an X3DComposedGeometryNode (X3D 4.0, 11.3.2).
   *
   * @param creaseAngle radians, for nodes that specify no normals
   * @param ownTexCoords the texture coordinates of a node that specifies none; null for those of
   *     X3D 4.0, 13.3.6
   */
  Mesh composed(Indices indices, double creaseAngle, @Nullable VertexAttribute ownTexCoords) {
    boolean colorPerVertex = job.node().bool("colorPerVertex");
    boolean normalPerVertex = job.node().bool("normalPerVertex");
    VertexAttribute colors =
        attribute(
            "colors",
            GeometryPropertyReader.colors(job),
            4,
            indices.color(),
            colorPerVertex,
            "left out");
    VertexAttribute given =
        attribute(
            "normals",
            GeometryPropertyReader.normals(job),
            3,
            indices.normal(),
            normalPerVertex,
            "generated");
    VertexAttribute texCoords =
        attribute(
            "texture coordinates",
            GeometryPropertyReader.texCoords(job),
            2,
            indices.texCoord(),
            true,
            "generated");
    VertexAttribute normals = given == null ? null : complete(given);
    return mesh(
        colors,
        normals,
        texCoords == null ? ownTexCoords : texCoords,
        more(indices, normalPerVertex),
        creaseAngle);
  }

  /** Returns further texture coordinates and attributes; unusable sets keep their position. */
  private List<VertexAttribute> more(Indices indices, boolean normalPerVertex) {
    List<VertexAttribute> more = new ArrayList<>();
    int[] index = indices.texCoord();
    for (VertexAttribute given : GeometryPropertyReader.moreTexCoords(job)) {
      if (more.size() == ShaderVertexAttributes.MOST) {
        job.problem("has more texture coordinates than graphics cards support; the last are all 0");
        break;
      }
      int size = given.components();
      // an empty set only keeps its position in the list
      VertexAttribute usable =
          given.count() == 0
              ? null
              : attribute("texture coordinates", given.values(), size, index, true, "all 0");
      more.add(
          usable != null
              ? usable
              : new VertexAttribute(new float[size], size, new int[corners.length]));
    }
    tangents(indices, normalPerVertex, more);
    more.addAll(ShaderVertexAttributes.of(job, corners, more.size()));
    return more;
  }

  /** Adds the tangents, which are indexed like the normals. */
  private void tangents(Indices indices, boolean normalPerVertex, List<VertexAttribute> more) {
    float[] given =
        more.size() < ShaderVertexAttributes.MOST ? GeometryPropertyReader.tangents(job) : null;
    VertexAttribute tangents =
        attribute(
            "tangents",
            given,
            4,
            indices.normal(),
            normalPerVertex,
            "left out; they follow from texture coordinates");
    if (tangents != null) {
      more.add(new VertexAttribute(tangents.values(), 4, tangents.ids(), Mesh.TANGENTS));
    }
  }

  /** Returns the mesh with given attributes; normals that are null are generated. */
  Mesh mesh(
      @Nullable VertexAttribute colors,
      @Nullable VertexAttribute normals,
      @Nullable VertexAttribute texCoords,
      double creaseAngle) {
    return mesh(colors, normals, texCoords, List.of(), creaseAngle);
  }

  private Mesh mesh(
      @Nullable VertexAttribute colors,
      @Nullable VertexAttribute normals,
      @Nullable VertexAttribute texCoords,
      List<VertexAttribute> moreTexCoords,
      double creaseAngle) {
    VertexAttribute shaded =
        normals != null
            ? normals
            : NormalGenerator.of(points.xyz(), corners, triangles.faces(), faceCount, creaseAngle);
    return new IndexedMeshBuilder(points.xyz(), corners, shaded, colors, texCoords, moreTexCoords)
        .mesh(Mesh.Primitive.TRIANGLES, job.node().bool("solid"), true);
  }

  private @Nullable VertexAttribute attribute(
      String what,
      float @Nullable [] values,
      int components,
      int[] index,
      boolean perVertex,
      String otherwise) {
    if (values == null) {
      return null;
    }
    int count = values.length / components;
    int[] ids = perVertex ? perVertex(index, count) : perFace(index, count);
    if (ids == null && !(perVertex && index.length == 0 && covers(count))) {
      job.problem("has too few " + what + " for its faces; they are " + otherwise);
      return null;
    }
    return new VertexAttribute(values, components, ids);
  }

  /** Returns whether each point used has a tuple of the same index. */
  private boolean covers(int count) {
    if (count >= points.count()) {
      return true;
    }
    for (int point : corners) {
      if (point >= count) {
        return false;
      }
    }
    return true;
  }

  private int @Nullable [] perVertex(int[] index, int count) {
    if (index.length == 0) {
      return null;
    }
    int[] positions = triangles.corners();
    int[] ids = new int[corners.length];
    for (int corner = 0; corner < ids.length; corner++) {
      int position = positions[corner];
      int id = position < index.length ? index[position] : -1;
      if (id < 0 || id >= count) {
        return null;
      }
      ids[corner] = id;
    }
    return ids;
  }

  private int @Nullable [] perFace(int[] index, int count) {
    int[] faces = triangles.faces();
    int[] ids = new int[corners.length];
    for (int corner = 0; corner < ids.length; corner++) {
      int face = faces[corner / 3];
      int id = index.length == 0 ? face : face < index.length ? index[face] : -1;
      if (id < 0 || id >= count) {
        return null;
      }
      ids[corner] = id;
    }
    return ids;
  }

  /** Replaces normals of length 0 by the face normals. */
  private VertexAttribute complete(VertexAttribute given) {
    float[] values = given.values();
    int[] ids = given.ids();
    int[] completed = null;
    for (int corner = 0; corner < corners.length; corner++) {
      int id = ids == null ? corners[corner] : ids[corner];
      if (values[3 * id] == 0 && values[3 * id + 1] == 0 && values[3 * id + 2] == 0) {
        if (completed == null) {
          completed = ids == null ? corners.clone() : ids;
        }
        completed[corner] = given.count() + triangles.faces()[corner / 3];
      }
    }
    if (completed == null) {
      return given;
    }
    job.problem("has normals of length 0; the normals of the faces are used instead");
    float[] faceNormals = FaceNormals.of(points.xyz(), corners, triangles.faces(), faceCount);
    float[] all = new float[3 * given.count() + faceNormals.length];
    System.arraycopy(values, 0, all, 0, 3 * given.count());
    System.arraycopy(faceNormals, 0, all, 3 * given.count(), faceNormals.length);
    return new VertexAttribute(all, 3, completed);
  }
}
