package org.selectiverenderer.geometry.mesh;

import java.util.List;
import org.joml.Matrix3d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/** Merges many transformed copies of a mesh into one mesh. */
public final class MeshReplicator {
  /** The maximum number of vertices of all copies together. */
  private static final int MOST_VERTICES = 4_000_000;

  private static final int MOST_INDICES = 12_000_000;

  private MeshReplicator() {}

  /** Returns the maximum number of copies of a mesh. */
  public static int most(Mesh mesh) {
    return Math.min(
        MOST_VERTICES / Math.max(1, mesh.vertexCount()),
        MOST_INDICES / Math.max(1, mesh.indices().length));
  }

  /**
   * Returns the mesh of the copies, in order; no more than {@link #most}. The winding of a mirrored
   * copy is reversed, so that its outside stays its front.
   *
   * @param places the transform of each copy
   */
  public static Mesh of(Mesh mesh, List<? extends Matrix4dc> places) {
    int copies = Math.min(places.size(), most(mesh));
    int vertices = mesh.vertexCount();
    int each = mesh.indices().length;
    float[] positions = new float[3 * vertices * copies];
    float[] normals = mesh.normals() == null ? null : new float[3 * vertices * copies];
    int[] indices = new int[each * copies];
    for (int copy = 0; copy < copies; copy++) {
      Matrix4dc place = places.get(copy);
      place(mesh, place, positions, normals, 3 * vertices * copy);
      boolean mirrored = mesh.primitive() == Mesh.Primitive.TRIANGLES && place.determinant3x3() < 0;
      for (int k = 0; k < each; k++) {
        int from = mirrored && k % 3 != 0 ? k / 3 * 3 + 3 - k % 3 : k;
        indices[each * copy + k] = mesh.indices()[from] + vertices * copy;
      }
    }
    return new Mesh(
        mesh.primitive(),
        positions,
        normals,
        repeated(mesh.colors(), copies),
        repeated(mesh.texCoords(), copies),
        mesh.moreTexCoords().stream()
            .map(
                more ->
                    more.name().equals(Mesh.TANGENTS)
                        ? turned(more, places, copies)
                        : repeated(more, copies))
            .toList(),
        indices,
        mesh.solid(),
        Mesh.boundsOf(positions, indices));
  }

  private static void place(
      Mesh mesh, Matrix4dc place, float[] positions, float @Nullable [] normals, int at) {
    Vector3d v = new Vector3d();
    Matrix3d normalMatrix = place.normal(new Matrix3d());
    for (int i = 0; i < mesh.positions().length; i += 3) {
      place.transformPosition(
          v.set(mesh.positions()[i], mesh.positions()[i + 1], mesh.positions()[i + 2]));
      put(v, positions, at + i);
      float[] from = mesh.normals();
      if (from != null && normals != null) {
        normalMatrix.transform(v.set(from[i], from[i + 1], from[i + 2])).normalize();
        put(v.isFinite() ? v : v.set(0, 0, 1), normals, at + i);
      }
    }
  }

  private static Mesh.TexCoords repeated(Mesh.TexCoords more, int copies) {
    return new Mesh.TexCoords(more.components(), repeatedAll(more.values(), copies), more.name());
  }

  /** Transforms tangents with the surface; a mirrored copy has the opposite handedness. */
  private static Mesh.TexCoords turned(
      Mesh.TexCoords tangents, List<? extends Matrix4dc> places, int copies) {
    Mesh.TexCoords all = repeated(tangents, copies);
    Vector3d v = new Vector3d();
    for (int copy = 0; copy < copies; copy++) {
      Matrix4dc place = places.get(copy);
      boolean mirrored = place.determinant3x3() < 0;
      int from = tangents.values().length * copy;
      for (int i = from; i < from + tangents.values().length; i += 4) {
        float[] values = all.values();
        place.transformDirection(v.set(values[i], values[i + 1], values[i + 2])).normalize();
        put(v, values, i);
        values[i + 3] = mirrored ? -values[i + 3] : values[i + 3];
      }
    }
    return all;
  }

  /** Stores a vector, clamped to a float's range. */
  private static void put(Vector3d v, float[] to, int at) {
    for (int axis = 0; axis < 3; axis++) {
      double value = v.get(axis);
      to[at + axis] =
          Double.isNaN(value)
              ? 0
              : (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, value));
    }
  }

  private static float @Nullable [] repeated(float @Nullable [] values, int times) {
    return values == null ? null : repeatedAll(values, times);
  }

  private static float[] repeatedAll(float[] values, int times) {
    float[] all = new float[values.length * times];
    for (int i = 0; i < times; i++) {
      System.arraycopy(values, 0, all, values.length * i, values.length);
    }
    return all;
  }
}
