package org.selectiverenderer.radiosity.scene;

import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * One instance of a shape in world coordinates that takes part in the light transport: its mesh,
 * reflectance, emission and transmittance. Its triangles are consecutive in the scene's triangles,
 * in the order of its mesh.
 *
 * @param mesh the shape's mesh in local coordinates
 * @param positions x, y, z of each vertex of the mesh in world coordinates, metres
 * @param normals x, y, z of each vertex's unit normal in world coordinates
 * @param mirrored whether its transform mirrors the mesh, so that the winding of triangles is
 *     swapped
 * @param version the version of an object that it belongs to, or {@link
 *     org.selectiverenderer.radiosity.trace.ObjectVersionIndex#FIXED}
 * @param budget number of the region with a polygon budget that it belongs to, or -1
 * @param firstTriangle number of its first triangle in the scene's triangles
 * @param reflectance r, g, b of each triangle, or of all triangles if there are three numbers only
 * @param emission emitted luminance r, g, b, cd/m2
 * @param transmittance share of light that passes straight through
 */
public record Body(
    ShapeInstance shape,
    Mesh mesh,
    float[] positions,
    float[] normals,
    boolean mirrored,
    int version,
    int budget,
    int firstTriangle,
    float[] reflectance,
    float[] emission,
    float transmittance) {

  public int triangles() {
    return mesh.polygons();
  }

  public boolean glows() {
    return emission[0] > 0 || emission[1] > 0 || emission[2] > 0;
  }

  /** Returns the index at which the reflectance of a triangle begins. */
  public int reflectanceAt(int triangle) {
    return reflectance.length == 3 ? 0 : 3 * triangle;
  }

  /**
   * Returns the mesh vertex at a corner, 0 to 2, of a triangle, counter-clockwise in world
   * coordinates.
   */
  public int vertex(int triangle, int corner) {
    int at = mirrored && corner > 0 ? 3 - corner : corner;
    return mesh.indices()[3 * triangle + at];
  }
}
