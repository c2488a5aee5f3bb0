package org.selectiverenderer.radiosity;

import java.util.OptionalDouble;

/**
 * Settings of where the computed light is stored (lightmaps or vertex colours) and how finely.
 *
 * @param kind lightmaps, or colours at the vertices
 * @param texelsPerMetre texel density of surfaces as large as a room's; empty for the density that
 *     the budget allows, up to a default
 * @param megabytes upper limit of the memory of all lightmaps together, in units of 2^20 bytes at
 *     three bytes a texel; their files are smaller
 * @param highlights whether glossy shapes keep their specular highlights, for which lights stay on
 *     in the lit scene
 * @param noise the requested standard error of the light in lightmaps, percent of the light
 */
public record LightStorageSettings(
    Kind kind, OptionalDouble texelsPerMetre, double megabytes, boolean highlights, double noise) {
  /** Lightmaps or vertex colours. */
  public enum Kind {
    TEXTURES,
    VERTICES
  }

  private static final double BUDGET = 24;
  private static final double NOISE = 8;

  /** Lightmaps, as fine as the budget allows. */
  public static final LightStorageSettings DEFAULT =
      new LightStorageSettings(Kind.TEXTURES, OptionalDouble.empty(), BUDGET, true);

  /** Colours at the vertices. */
  public static final LightStorageSettings VERTICES =
      new LightStorageSettings(Kind.VERTICES, OptionalDouble.empty(), BUDGET, false);

  private static final double LEAST_NOISE = 0.1;
  private static final double DENSEST = 10_000;
  private static final double SMALLEST = 0.01;

  /** Largest budget: three numbers for each texel of all lightmaps must fit into one Java array. */
  private static final double LARGEST = 2_000;

  /** Creates settings with the default noise. */
  public LightStorageSettings(
      Kind kind, OptionalDouble texelsPerMetre, double megabytes, boolean highlights) {
    this(kind, texelsPerMetre, megabytes, highlights, NOISE);
  }

  public LightStorageSettings {
    texelsPerMetre.ifPresent(
        density ->
            require(
                density > 0 && density <= DENSEST,
                "the texels per metre must be above 0 and at most 10000"));
    require(
        megabytes >= SMALLEST && megabytes <= LARGEST,
        "the texture budget must be from 0.01 to 2000 megabytes");
    require(noise >= LEAST_NOISE && noise <= 100, "the noise must be from 0.1 to 100 percent");
  }

  /** Returns whether light is stored in lightmaps. */
  public boolean inTextures() {
    return kind == Kind.TEXTURES;
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
