package org.selectiverenderer.geometry.mesh;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/** Transforms meshes by affine matrices. */
public final class MeshTransformer {
  private MeshTransformer() {}

  /**
   * Returns the mesh in its parent's frame, with unit normals. A mirroring matrix reverses the
   * winding of triangles, so that fronts stay fronts.
   *
   * @param placement the affine transform from the mesh's frame to the parent's
   */
  public static Mesh place(Mesh mesh, Matrix4dc placement) {
    if (new Matrix4d().equals(placement)) {
      return mesh;
    }
    float[] positions = mesh.positions().clone();
    Vector3d v = new Vector3d();
    for (int i = 0; i < positions.length; i += 3) {
      placement.transformPosition(v.set(positions[i], positions[i + 1], positions[i + 2]));
      put(v, positions, i);
    }
    int[] indices =
        mesh.primitive() == Mesh.Primitive.TRIANGLES
            ? triangles(mesh.indices(), placement)
            : mesh.indices();
    return new Mesh(
        mesh.primitive(),
        positions,
        normals(mesh.normals(), placement),
        mesh.colors(),
        mesh.texCoords(),
        indices,
        mesh.solid(),
        Mesh.boundsOf(positions, indices));
  }

  /** Returns triangles with the winding that keeps their fronts: reversed if mirrored. */
  public static int[] triangles(int[] indices, Matrix4dc placement) {
    if (placement.determinant3x3() >= 0) {
      return indices;
    }
    int[] turned = indices.clone();
    for (int i = 0; i < turned.length; i += 3) {
      turned[i + 1] = indices[i + 2];
      turned[i + 2] = indices[i + 1];
    }
    return turned;
  }

  private static float @Nullable [] normals(float @Nullable [] given, Matrix4dc placement) {
    if (given == null) {
      return null;
    }
    Matrix3d matrix = placement.normal(new Matrix3d());
    float[] normals = given.clone();
    Vector3d v = new Vector3d();
    for (int i = 0; i < normals.length; i += 3) {
      matrix.transform(v.set(normals[i], normals[i + 1], normals[i + 2]));
      put(v.lengthSquared() > 0 && v.isFinite() ? v.normalize() : v.set(0, 1, 0), normals, i);
    }
    return normals;
  }

  private static void put(Vector3d v, float[] values, int at) {
    values[at] = (float) v.x;
    values[at + 1] = (float) v.y;
    values[at + 2] = (float) v.z;
  }
}
