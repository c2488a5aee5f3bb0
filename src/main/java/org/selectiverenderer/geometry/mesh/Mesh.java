package org.selectiverenderer.geometry.mesh;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Geometry as primitive arrays, ready for a vertex and an index buffer: local coordinates, right
 * handed, lengths in the scene's unit. Immutable by convention: nobody writes into the arrays.
 *
 * @param primitive what three, two or one indices make
 * @param positions x, y, z per vertex; all finite
 * @param normals unit vectors, x, y, z per vertex; null for lines and points without normals, which
 *     are drawn unlit
 * @param colors r, g, b, a per vertex, or null: they replace the material's diffuse colour
 * @param texCoords s, t per vertex, or null when the geometry has none
 * @param moreTexCoords what else a MultiTextureCoordinate, a TextureCoordinate3D or 4D gives, then
 *     the attributes of the geometry; what refines, merges or simplifies a mesh leaves them out
 * @param indices into the vertices; triangles are wound counter-clockwise seen from their front
 * @param solid whether only the front is seen
 * @param bounds min x, y, z, max x, y, z of the positions used; empty geometry has min above max
 */
public record Mesh(
    Primitive primitive,
    float[] positions,
    float @Nullable [] normals,
    float @Nullable [] colors,
    float @Nullable [] texCoords,
    List<TexCoords> moreTexCoords,
    int[] indices,
    boolean solid,
    float[] bounds) {

  /**
   * Texture coordinates of any size, or an attribute for programs of shaders.
   *
   * @param components numbers per vertex: of coordinates 2, 3 or 4, s, t, r, q; of an attribute 1
   *     to 4
   * @param values of all vertices one after the other
   * @param name of the attribute, with {@code [n]} behind it for each further column of a matrix;
   *     empty for texture coordinates
   */
  public record TexCoords(int components, float[] values, String name) {
    /** Texture coordinates. */
    public TexCoords(int components, float[] values) {
      this(components, values, "");
    }
  }

  /**
   * The name of the attribute that has the depths of fog (X3D 4.0, 24.4.2), one for each vertex.
   */
  public static final String FOG_DEPTH = "sr_FogCoord";

  /**
   * Where the depths of fog are among the further texture coordinates and attributes; -1 for a mesh
   * without any.
   */
  public int fogDepth() {
    return place(FOG_DEPTH);
  }

  /**
   * The name of the attribute that has the tangents (draft of X3D 4.1, Tangent), x, y, z and the
   * side of the third axis, 1 or -1, for each vertex. X_ITE's programs know them by it too.
   */
  public static final String TANGENTS = "x3d_Tangent";

  /** Where the tangents are, likewise. */
  public int tangents() {
    return place(TANGENTS);
  }

  private int place(String name) {
    for (int i = moreTexCoords.size() - 1; i >= 0; i--) {
      if (moreTexCoords.get(i).name().equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /** A mesh with one set of texture coordinates at most. */
  public Mesh(
      Primitive primitive,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] colors,
      float @Nullable [] texCoords,
      int[] indices,
      boolean solid,
      float[] bounds) {
    this(primitive, positions, normals, colors, texCoords, List.of(), indices, solid, bounds);
  }

  /** What the indices make. */
  public enum Primitive {
    /** Three indices for each. */
    TRIANGLES,
    /** Two indices for each. */
    LINES,
    /** One index for each. */
    POINTS
  }

  /** How many vertices it has. */
  public int vertexCount() {
    return positions.length / 3;
  }

  /** The number of triangles; lines and points are no polygons. */
  public int polygons() {
    return primitive == Primitive.TRIANGLES ? indices.length / 3 : 0;
  }

  /** Whether it has nothing to draw. */
  public boolean isEmpty() {
    return indices.length == 0;
  }

  /** The bounds of the vertices that the indices use. */
  public static float[] boundsOf(float[] positions, int[] indices) {
    float[] b = {
      Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
      Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY
    };
    for (int index : indices) {
      for (int axis = 0; axis < 3; axis++) {
        float value = positions[3 * index + axis];
        b[axis] = Math.min(b[axis], value);
        b[axis + 3] = Math.max(b[axis + 3], value);
      }
    }
    return b;
  }
}
