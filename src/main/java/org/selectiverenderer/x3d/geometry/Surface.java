package org.selectiverenderer.x3d.geometry;

import org.jspecify.annotations.Nullable;

/** The last steps from triangles to a mesh, common to all surfaces made of faces. */
final class Surface {
  /** The index streams of a node that has its own for each property; empty: those of the points. */
  record Indices(int[] color, int[] normal, int[] texCoord) {
    static final Indices NONE = new Indices(new int[0], new int[0], new int[0]);
  }

  private final Job job;
  private final Points points;
  private final TriangleList triangles;
  private final int faceCount;
  private final int[] corners;

  /**
   * Turns the triangles round if the node's {@code ccw} is FALSE, and leaves out the degenerate.
   *
   * @param triangles of points in range and finite
   * @param faceCount above all face numbers of the triangles
   */
  Surface(Job job, Points points, TriangleList triangles, int faceCount) {
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
   * The mesh of a node with the fields of X3DComposedGeometryNode (X3D 4.0, 11.3.2).
   *
   * @param creaseAngle radians, for nodes that give no normals
   * @param ownTexCoords what the node takes when it gives no texture coordinates; null for those of
   *     {@link DefaultTextureCoordinates}
   */
  Mesh composed(Indices indices, double creaseAngle, @Nullable Attribute ownTexCoords) {
    boolean colorPerVertex = job.node().bool("colorPerVertex");
    boolean normalPerVertex = job.node().bool("normalPerVertex");
    Attribute colors =
        attribute("colors", Values.colors(job), 4, indices.color(), colorPerVertex, "left out");
    Attribute given =
        attribute(
            "normals", Values.normals(job), 3, indices.normal(), normalPerVertex, "generated");
    Attribute texCoords =
        attribute(
            "texture coordinates", Values.texCoords(job), 2, indices.texCoord(), true, "generated");
    Attribute normals = given == null ? null : complete(given);
    return mesh(colors, normals, texCoords == null ? ownTexCoords : texCoords, creaseAngle);
  }

  /** The mesh with given properties; normals that are null are generated. */
  Mesh mesh(
      @Nullable Attribute colors,
      @Nullable Attribute normals,
      @Nullable Attribute texCoords,
      double creaseAngle) {
    Attribute shaded =
        normals != null
            ? normals
            : GeneratedNormals.of(points.xyz(), corners, triangles.faces(), faceCount, creaseAngle);
    return new Welder(points.xyz(), corners, shaded, colors, texCoords)
        .mesh(Mesh.Primitive.TRIANGLES, job.node().bool("solid"), true);
  }

  private @Nullable Attribute attribute(
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
    return new Attribute(values, components, ids);
  }

  /** Whether each point that is used has a tuple of its own number. */
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

  /** Puts the face's normal wherever the given one has no direction. */
  private Attribute complete(Attribute given) {
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
    job.problem("has normals without a direction; the normals of the faces take their place");
    float[] faceNormals = FaceNormals.of(points.xyz(), corners, triangles.faces(), faceCount);
    float[] all = new float[3 * given.count() + faceNormals.length];
    System.arraycopy(values, 0, all, 0, 3 * given.count());
    System.arraycopy(faceNormals, 0, all, 3 * given.count(), faceNormals.length);
    return new Attribute(all, 3, completed);
  }
}
