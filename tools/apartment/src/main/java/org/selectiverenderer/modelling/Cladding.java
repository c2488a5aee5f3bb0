package org.selectiverenderer.modelling;

import org.joml.Vector3d;

/**
 * A picture that covers a surface, and how it is laid. Places of the picture follow from places of
 * the surface, so that dividing triangles or moving their corners within the surface leaves the
 * picture where it was.
 *
 * @param file the picture's URL as the model's file names it
 * @param laying which place of the picture is seen where
 * @param repeats whether the picture goes on beyond its edges, else its edges' colours do
 * @param slanted whether it is mostly seen at a slant, as a floor is: then it is sampled so that it
 *     neither shimmers nor blurs as one walks, which costs time without a graphics card
 */
public record Cladding(String file, Laying laying, boolean repeats, boolean slanted) {

  /** From a place of a surface to a place of a picture. */
  @FunctionalInterface
  public interface Laying {
    /**
     * @param place metres
     * @param normal of the triangle, of any length
     * @return s and t: 0 to 1 is the picture, which repeats beyond
     */
    double[] at(Vector3d place, Vector3d normal);
  }

  /**
   * Repeats at a width and height in metres, for walls, upright; a face takes it from whichever of
   * the six directions it looks most into.
   */
  public static Cladding metric(String file, double width, double height) {
    return new Cladding(file, repeating(0, 0, width, height), true, false);
  }

  /**
   * Likewise, for a floor: the place of this x and z shows the picture's lower left corner, and
   * north, -z, is up.
   */
  public static Cladding floor(double x, double z, String file, double width, double height) {
    return new Cladding(file, repeating(x, z, width, height), true, true);
  }

  private static Laying repeating(double x, double z, double width, double height) {
    return (place, normal) -> {
      double[] across = across(new Vector3d(place).sub(x, 0, z), normal);
      return new double[] {across[0] / width, across[1] / height};
    };
  }

  /**
   * A quarter of a pattern that is symmetrical to the planes x = 0 and z = 0, seen from above: the
   * picture's lower left corner is the middle. The mesh has edges along these planes.
   */
  public static Cladding quarter(String file, double width, double height) {
    return new Cladding(
        file,
        (place, normal) -> new double[] {Math.abs(place.x) / width, Math.abs(place.z) / height},
        false,
        true);
  }

  /** To the right and up, metres, for someone who looks at the face. */
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
