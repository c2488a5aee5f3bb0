package org.selectiverenderer.browser.collision;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Interpolates the attributes of a mesh (normal, texture coordinates) where a ray hits it. */
public final class HitAttributes {
  private HitAttributes() {}

  /**
   * Returns the unit normal, interpolated if the mesh has normals. On the back of a two-sided
   * surface it is the opposite one.
   *
   * @param to the matrix from the mesh's coordinates to those of the normal
   * @param direction the ray's direction, in the coordinates of the normal
   */
  public static Vector3d normal(
      Mesh mesh, MeshBvh tree, MeshBvh.MeshHit at, Matrix4dc to, Vector3dc direction) {
    Vector3d local = new Vector3d();
    float[] normals = mesh.normals();
    if (normals != null) {
      for (int corner = 0; corner < 3; corner++) {
        int first = 3 * vertex(mesh, at, corner);
        double weight = weight(at, corner);
        local.add(
            weight * normals[first], weight * normals[first + 1], weight * normals[first + 2]);
      }
    }
    if (local.lengthSquared() < 1e-12) {
      Vector3d a = tree.corner(at.triangle(), 0, new Vector3d());
      Vector3d ab = tree.corner(at.triangle(), 1, new Vector3d()).sub(a);
      ab.cross(tree.corner(at.triangle(), 2, new Vector3d()).sub(a), local);
    }
    Vector3d normal = to.normal(new Matrix4d()).transformDirection(local).normalize();
    return !mesh.solid() && normal.dot(direction) > 0 ? normal.negate() : normal;
  }

  /** Returns the texture coordinates s and t; null if the mesh has none. */
  public static @Nullable Vector2d texCoord(Mesh mesh, MeshBvh.MeshHit at) {
    float[] texCoords = mesh.texCoords();
    if (texCoords == null) {
      return null;
    }
    Vector2d result = new Vector2d();
    for (int corner = 0; corner < 3; corner++) {
      int first = 2 * vertex(mesh, at, corner);
      double weight = weight(at, corner);
      result.add(weight * texCoords[first], weight * texCoords[first + 1]);
    }
    return result;
  }

  private static int vertex(Mesh mesh, MeshBvh.MeshHit at, int corner) {
    return mesh.indices()[3 * at.triangle() + corner];
  }

  private static double weight(MeshBvh.MeshHit at, int corner) {
    return switch (corner) {
      case 0 -> 1 - at.u() - at.v();
      case 1 -> at.u();
      default -> at.v();
    };
  }
}
