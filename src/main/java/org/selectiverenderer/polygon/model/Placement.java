package org.selectiverenderer.polygon.model;

import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.geometry.Mesh;

/** Where a Transform puts its children, and meshes put there. */
final class Placement {
  private Placement() {}

  /** P' = T C R SR S -SR -C P (X3D 4.0, 10.4.4), after the placement of the node itself. */
  static Matrix4d of(NodeView transform, Matrix4dc parent) {
    float[] t = transform.floats("translation");
    float[] c = transform.floats("center");
    float[] s = transform.floats("scale");
    float[] orientation = transform.floats("scaleOrientation");
    Matrix4d matrix =
        new Matrix4d(parent)
            .translate(t[0] + (double) c[0], t[1] + (double) c[1], t[2] + (double) c[2]);
    rotate(matrix, transform.floats("rotation"), 1);
    rotate(matrix, orientation, 1);
    matrix.scale(s[0], s[1], s[2]);
    rotate(matrix, orientation, -1);
    return matrix.translate(-(double) c[0], -(double) c[1], -(double) c[2]);
  }

  private static void rotate(Matrix4d matrix, float[] r, int sign) {
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    if (length > 0 && r[3] != 0) {
      matrix.rotate(sign * (double) r[3], r[0] / length, r[1] / length, r[2] / length);
    }
  }

  /** The mesh in its parent's frame; a mirror turns the triangles, so that the front stays. */
  static Mesh place(Mesh mesh, Matrix4dc placement) {
    if (new Matrix4d().equals(placement)) {
      return mesh;
    }
    float[] positions = mesh.positions().clone();
    Vector3d v = new Vector3d();
    for (int i = 0; i < positions.length; i += 3) {
      placement.transformPosition(v.set(positions[i], positions[i + 1], positions[i + 2]));
      put(v, positions, i);
    }
    int[] indices = mesh.indices();
    if (placement.determinant3x3() < 0) {
      indices = indices.clone();
      for (int i = 0; i < indices.length; i += 3) {
        int kept = indices[i + 1];
        indices[i + 1] = indices[i + 2];
        indices[i + 2] = kept;
      }
    }
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
