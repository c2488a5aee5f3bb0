package org.selectiverenderer.modelling;

import org.joml.Vector3d;

/**
 * A texture image that covers a surface, with its projection onto the surface. Texture coordinates
 * are computed from positions on the surface, so that dividing triangles or moving their corners
 * within the surface leaves the image in place.
 *
 * @param file the image's URL as the model's file names it
 * @param laying the projection from positions to texture coordinates
 * @param repeats whether the image repeats beyond its edges; otherwise the colours of its edges
 *     continue
 * @param slanted whether the surface is mostly seen at a grazing angle, as a floor is: then the
 *     image is filtered between mipmap levels so that it neither shimmers nor blurs as one walks,
 *     which costs time without a graphics card
 */
public record TextureMapping(
    String file, TextureProjection laying, boolean repeats, boolean slanted) {

  /** Maps positions on a surface to texture coordinates. */
  @FunctionalInterface
  public interface TextureProjection {
    /**
     * @param place position on the surface, metres
     * @param normal normal of the triangle, of any length
     * @return texture coordinates s and t; 0 to 1 is the image
     */
    double[] at(Vector3d place, Vector3d normal);
  }

  /**
   * Returns an upright box projection for walls that repeats at a width and height in metres: each
   * face is projected along the axis closest to its normal.
   */
  public static TextureMapping metric(String file, double width, double height) {
    return new TextureMapping(file, repeating(0, 0, width, height), true, false);
  }

  /**
   * Returns a projection for a floor that repeats at a width and height in metres: the image's
   * lower left corner lies at this x and z, and north, -z, is up.
   */
  public static TextureMapping floor(double x, double z, String file, double width, double height) {
    return new TextureMapping(file, repeating(x, z, width, height), true, true);
  }

  private static TextureProjection repeating(double x, double z, double width, double height) {
    return (place, normal) -> {
      double[] across = across(new Vector3d(place).sub(x, 0, z), normal);
      return new double[] {across[0] / width, across[1] / height};
    };
  }

  /**
   * Returns a projection from above of a quarter of a pattern that is symmetrical about the planes
   * x = 0 and z = 0: the image's lower left corner is the pattern's middle. The mesh must have
   * edges along these planes.
   */
  public static TextureMapping quarter(String file, double width, double height) {
    return new TextureMapping(
        file,
        (place, normal) -> new double[] {Math.abs(place.x) / width, Math.abs(place.z) / height},
        false,
        true);
  }

  /**
   * Returns the coordinates on a face, metres to the right and up as seen by a viewer in front of
   * it.
   */
  private static double[] across(Vector3d place, Vector3d normal) {
    double x = Math.abs(normal.x);
    double y = Math.abs(normal.y);
    double z = Math.abs(normal.z);
    if (y >= x && y >= z) {
      return new double[] {place.x, normal.y > 0 ? -place.z : place.z};
    }
    return z >= x
        ? new double[] {normal.z > 0 ? place.x : -place.x, place.y}
        : new double[] {normal.x > 0 ? -place.z : place.z, place.y};
  }
}
