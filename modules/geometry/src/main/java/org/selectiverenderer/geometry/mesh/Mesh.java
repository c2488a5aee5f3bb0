package org.selectiverenderer.geometry.mesh;

import java.lang.ref.WeakReference;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * An indexed mesh in primitive arrays, ready for a vertex buffer and an index buffer, in
 * right-handed local coordinates and the scene's unit of length. It is immutable: the arrays must
 * not be modified.
 *
 * <p>A mesh that is kept for long, of which a scene has many, should be {@link #compact}. What it
 * can derive, that is the wide form of two-byte indices and default texture coordinates, takes
 * memory only while somebody has it. Two meshes are equal only if they are the same object.
 */
public final class Mesh {
  private final Primitive primitive;
  private final float[] positions;
  private final float @Nullable [] normals;
  private final float @Nullable [] colors;
  private final float @Nullable [] texCoords;
  private final boolean defaultTexCoords;
  private final List<TexCoords> moreTexCoords;
  private final CompactIndices indices;
  private final boolean solid;
  private final float[] bounds;

  /** The default texture coordinates, while somebody has them. */
  private volatile @Nullable WeakReference<float[]> derivedTexCoords;

  /**
   * Creates a mesh.
   *
   * @param primitive the primitive that three, two or one indices form
   * @param positions x, y, z per vertex; all finite
   * @param normals unit vectors, x, y, z per vertex; null for lines and points without normals,
   *     which are drawn unlit
   * @param colors r, g, b, a per vertex, or null; they replace the material's diffuse colour
   * @param texCoords s, t per vertex, or null if the geometry has none
   * @param moreTexCoords further texture coordinates of a MultiTextureCoordinate,
   *     TextureCoordinate3D or 4D, then vertex attributes for shaders; refining, merging or
   *     simplifying a mesh drops them
   * @param indices vertex indices; triangles are wound counter-clockwise seen from their front
   * @param solid whether back faces are culled
   * @param bounds min x, y, z, max x, y, z of the vertices used; min is above max in an empty mesh
   */
  public Mesh(
      Primitive primitive,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] colors,
      float @Nullable [] texCoords,
      List<TexCoords> moreTexCoords,
      int[] indices,
      boolean solid,
      float[] bounds) {
    this(
        primitive,
        positions,
        normals,
        colors,
        texCoords,
        false,
        moreTexCoords,
        CompactIndices.of(indices),
        solid,
        bounds);
  }

  private Mesh(
      Primitive primitive,
      float[] positions,
      float @Nullable [] normals,
      float @Nullable [] colors,
      float @Nullable [] texCoords,
      boolean defaultTexCoords,
      List<TexCoords> moreTexCoords,
      CompactIndices indices,
      boolean solid,
      float[] bounds) {
    this.primitive = primitive;
    this.positions = positions;
    this.normals = normals;
    this.colors = colors;
    this.texCoords = texCoords;
    this.defaultTexCoords = defaultTexCoords;
    this.moreTexCoords = moreTexCoords;
    this.indices = indices;
    this.solid = solid;
    this.bounds = bounds;
  }

  /**
   * Texture coordinates of any dimension, or a vertex attribute for shader programs.
   *
   * @param components numbers per vertex: 2, 3 or 4 for texture coordinates (s, t, r, q), 1 to 4
   *     for an attribute
   * @param values the numbers of all vertices
   * @param name the attribute's name, followed by {@code [n]} for each further column of a matrix;
   *     empty for texture coordinates
   */
  public record TexCoords(int components, float[] values, String name) {
    /** Creates texture coordinates. */
    public TexCoords(int components, float[] values) {
      this(components, values, "");
    }
  }

  /**
   * The name of the attribute for the fog depth of each vertex (FogCoordinate, X3D 4.0, 24.4.2).
   */
  public static final String FOG_DEPTH = "sr_FogCoord";

  /** Returns the index of the fog depths in {@link #moreTexCoords}; -1 if there are none. */
  public int fogDepth() {
    return place(FOG_DEPTH);
  }

  /**
   * The name of the attribute for tangents (draft of X3D 4.1, Tangent): x, y, z and the handedness
   * of the tangent frame, 1 or -1, for each vertex. X_ITE's shader programs use the same name.
   */
  public static final String TANGENTS = "x3d_Tangent";

  /** Returns the index of the tangents in {@link #moreTexCoords}; -1 if there are none. */
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

  /** Creates a mesh with at most one set of texture coordinates. */
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

  /** The primitive type. */
  public enum Primitive {
    /** Triangles of three indices each. */
    TRIANGLES,
    /** Line segments of two indices each. */
    LINES,
    /** Points of one index each. */
    POINTS
  }

  /**
   * Returns this mesh with the default texture coordinates of X3D 4.0, 13.3.6, which are computed
   * when they are read, and forgotten when nobody has them any more.
   */
  public Mesh withDefaultTexCoords() {
    return copy(null, true, indices);
  }

  /** Returns whether an array is one of those that this mesh keeps. */
  public boolean keeps(Object array) {
    return array == positions
        || array == normals
        || array == colors
        || array == texCoords
        || indices.keeps(array)
        || moreTexCoords.stream().anyMatch(more -> array == more.values());
  }

  /** Returns this mesh with its indices in two bytes each, if that is worth while and possible. */
  public Mesh compact() {
    CompactIndices less = indices.compact(vertexCount());
    return less == indices ? this : copy(texCoords, defaultTexCoords, less);
  }

  private Mesh copy(float @Nullable [] texture, boolean derived, CompactIndices order) {
    return new Mesh(
        primitive,
        positions,
        normals,
        colors,
        texture,
        derived,
        moreTexCoords,
        order,
        solid,
        bounds);
  }

  /** Returns the primitive that three, two or one indices form. */
  public Primitive primitive() {
    return primitive;
  }

  /** Returns x, y, z per vertex. */
  public float[] positions() {
    return positions;
  }

  /** Returns unit vectors, x, y, z per vertex; null for lines and points without normals. */
  public float @Nullable [] normals() {
    return normals;
  }

  /** Returns r, g, b, a per vertex; null if the material has the colour. */
  public float @Nullable [] colors() {
    return colors;
  }

  /** Returns whether there are texture coordinates; this makes none, unlike {@link #texCoords}. */
  public boolean hasTexCoords() {
    return texCoords != null || defaultTexCoords;
  }

  /** Returns s, t per vertex; null if the geometry has none. */
  public float @Nullable [] texCoords() {
    if (texCoords != null || !defaultTexCoords) {
      return texCoords;
    }
    WeakReference<float[]> known = derivedTexCoords;
    float[] derived = known == null ? null : known.get();
    if (derived == null) {
      derived = DefaultTexCoords.of(positions, bounds);
      derivedTexCoords = new WeakReference<>(derived);
    }
    return derived;
  }

  /** Returns further texture coordinates, then vertex attributes for shaders. */
  public List<TexCoords> moreTexCoords() {
    return moreTexCoords;
  }

  /** Returns the number of indices; this makes none, unlike {@link #indices}. */
  public int indexCount() {
    return indices.count();
  }

  /** Returns vertex indices; triangles are wound counter-clockwise seen from their front. */
  public int[] indices() {
    return indices.array();
  }

  /** Returns whether back faces are culled. */
  public boolean solid() {
    return solid;
  }

  /** Returns min x, y, z, max x, y, z of the vertices used; min is above max if there are none. */
  public float[] bounds() {
    return bounds;
  }

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positions.length / 3;
  }

  /** Returns the number of triangles; lines and points do not count as polygons. */
  public int polygons() {
    return primitive == Primitive.TRIANGLES ? indices.count() / 3 : 0;
  }

  /** Returns whether there is nothing to draw. */
  public boolean isEmpty() {
    return indices.count() == 0;
  }

  /** Returns the bounds of the vertices that the indices use: min x, y, z, max x, y, z. */
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
