package org.selectiverenderer.radiosity.mesh;

import org.selectiverenderer.radiosity.scene.Body;

/**
 * A triangle that carries light, a whole triangle of the scene or a part of one.
 *
 * @param source number of the triangle in the scene
 * @param corners x, y, z of the three corners in world coordinates, metres
 * @param local x, y, z of the corners in the shape's local coordinates
 * @param normals x, y, z at the corners: corners with the same position and normal share their
 *     light
 */
public record Facet(int source, float[] corners, float[] local, float[] normals) {

  /** Returns the facet of a whole triangle of a body. */
  static Facet of(Body body, int triangle) {
    float[] corners = new float[9];
    float[] local = new float[9];
    float[] normals = new float[9];
    for (int corner = 0; corner < 3; corner++) {
      int vertex = body.vertex(triangle, corner);
      System.arraycopy(body.positions(), 3 * vertex, corners, 3 * corner, 3);
      System.arraycopy(body.mesh().positions(), 3 * vertex, local, 3 * corner, 3);
      System.arraycopy(body.normals(), 3 * vertex, normals, 3 * corner, 3);
    }
    return new Facet(body.firstTriangle() + triangle, corners, local, normals);
  }
}
