package org.selectiverenderer.radiosity.mesh;

import org.selectiverenderer.radiosity.scene.Body;

/**
 * A triangle that carries light, a whole triangle of the scene or a part of one.
 *
 * @param source the triangle of the scene
 * @param corners x, y, z of three corners in the world
 * @param local x, y, z of the corners in the shape's own coordinates
 * @param normals x, y, z at the corners: corners with one place and one normal share their light
 */
public record Facet(int source, float[] corners, float[] local, float[] normals) {

  /** The facet of a whole triangle of a body. */
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
