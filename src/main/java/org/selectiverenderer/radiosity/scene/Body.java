package org.selectiverenderer.radiosity.scene;

import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/**
 * A shape in one place that takes part in the light. Its triangles are consecutive, in the order of
 * its mesh.
 *
 * @param mesh in local coordinates
 * @param positions x, y, z per vertex of the mesh in the world, metres
 * @param normals x, y, z per vertex in the world
 * @param mirrored whether its place turns triangles inside out, so that their winding is swapped
 * @param version of an object, or {@link org.selectiverenderer.radiosity.trace.Versions#FIXED}
 * @param budget the region whose polygons are to come to a given number, or -1
 * @param firstTriangle in the scene's triangles
 * @param reflectance r, g, b of each triangle, or of all when there are three numbers
 * @param emission luminance r, g, b, cd/m2
 * @param transmittance the share of light that goes straight through
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

  /** Where the reflectance of its i-th triangle begins. */
  public int reflectanceAt(int triangle) {
    return reflectance.length == 3 ? 0 : 3 * triangle;
  }

  /** The vertex of the mesh at a corner, 0 to 2, of its i-th triangle, counter-clockwise. */
  public int vertex(int triangle, int corner) {
    int at = mirrored && corner > 0 ? 3 - corner : corner;
    return mesh.indices()[3 * triangle + at];
  }
}
