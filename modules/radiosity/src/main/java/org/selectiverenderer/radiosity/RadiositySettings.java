package org.selectiverenderer.radiosity;

import java.util.OptionalDouble;

/**
 * The parameters of the radiosity computation (thesis 5.2.1). Lengths are metres.
 *
 * @param iterations largest number of iterations, that is of reflections
 * @param quality initial quality: percent of the energy distributed at which iterations stop
 * @param minMesh edges are not divided below this; empty for a tenth of {@code maxMesh}
 * @param maxMesh edges of the largest faces after subdivision; empty for a 40th of the scene's
 *     largest extent
 * @param globalSubdivision whether surfaces without versions are subdivided at all
 * @param regather whether light at vertices and texels is gathered by rays (final gathering), or
 *     taken from the patches of the solution, which is faster and coarser
 * @param photometric whether the light of point and spot lights falls with the square of the
 *     distance, or by their {@code attenuation} as X3D draws them
 * @param rays number of rays gathered at each vertex or irradiance record
 * @param seed random seed of all point sets
 * @param exposure stops brighter (above 0) or darker than the automatic exposure
 * @param maxPolygons largest number of polygons of surfaces without a polygon budget after
 *     subdivision
 * @param store where the light is stored
 */
public record RadiositySettings(
    int iterations,
    double quality,
    OptionalDouble minMesh,
    OptionalDouble maxMesh,
    boolean globalSubdivision,
    boolean regather,
    boolean photometric,
    int rays,
    int seed,
    double exposure,
    int maxPolygons,
    LightStorageSettings store) {

  /** The settings of the command without options. */
  public static final RadiositySettings DEFAULT =
      new RadiositySettings(
          50,
          98,
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          true,
          true,
          true,
          64,
          1,
          0,
          300_000,
          LightStorageSettings.DEFAULT);

  public RadiositySettings {
    require(iterations >= 1, "the number of iterations must be at least 1");
    require(quality > 0 && quality <= 100, "the quality must be above 0 and at most 100 percent");
    minMesh.ifPresent(size -> require(size > 0 && size < 1e6, "a mesh size must be above 0"));
    maxMesh.ifPresent(size -> require(size > 0 && size < 1e6, "a mesh size must be above 0"));
    if (minMesh.isPresent() && maxMesh.isPresent()) {
      require(
          minMesh.getAsDouble() <= maxMesh.getAsDouble(),
          "the minimum mesh size must not be larger than the maximum mesh size");
    }
    require(rays >= 4 && rays <= 65_536, "the number of rays must be from 4 to 65536");
    require(Math.abs(exposure) <= 20, "the exposure must be from -20 to 20 stops");
    require(maxPolygons >= 1, "the largest number of polygons must be at least 1");
  }

  /** Returns these settings with another storage of light. */
  public RadiositySettings with(LightStorageSettings other) {
    return with(rays, quality, other);
  }

  /** Returns these settings with another number of rays, another quality and another storage. */
  public RadiositySettings with(
      int otherRays, double otherQuality, LightStorageSettings otherStore) {
    return new RadiositySettings(
        iterations,
        otherQuality,
        minMesh,
        maxMesh,
        globalSubdivision,
        regather,
        photometric,
        otherRays,
        seed,
        exposure,
        maxPolygons,
        otherStore);
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalArgumentException(otherwise);
    }
  }

  /** Formats a length for a message, to three digits. */
  static String shortest(double length) {
    return String.format(java.util.Locale.ROOT, "%.3g", length);
  }
}
