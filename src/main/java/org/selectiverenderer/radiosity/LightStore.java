package org.selectiverenderer.radiosity;

import java.util.OptionalDouble;

/**
 * Where light is stored, and how well.
 *
 * @param kind pictures, or colours at the vertices
 * @param texelsPerMetre of surfaces as large as a room's; empty for as many as the budget allows,
 *     up to a default
 * @param megabytes of all pictures together in memory, at most: three bytes a texel, 2^20 bytes
 *     each; their files are smaller
 * @param highlights whether shapes that shine keep their highlights, by lights that stay on
 * @param noise the mean standard error that is wished for in pictures, percent of the light
 */
public record LightStore(
    Kind kind, OptionalDouble texelsPerMetre, double megabytes, boolean highlights, double noise) {
  /** Pictures or vertices. */
  public enum Kind {
    TEXTURES,
    VERTICES
  }

  private static final double BUDGET = 24;
  private static final double NOISE = 8;

  /** Pictures, as fine as the budget allows. */
  public static final LightStore DEFAULT =
      new LightStore(Kind.TEXTURES, OptionalDouble.empty(), BUDGET, true);

  /** Colours at the vertices. */
  public static final LightStore VERTICES =
      new LightStore(Kind.VERTICES, OptionalDouble.empty(), BUDGET, false);

  private static final double LEAST_NOISE = 0.1;
  private static final double DENSEST = 10_000;
  private static final double SMALLEST = 0.01;

  /** Three numbers a texel of all pictures must be as many as an array has. */
  private static final double LARGEST = 2_000;

  /** With the noise that is wished for by default. */
  public LightStore(
      Kind kind, OptionalDouble texelsPerMetre, double megabytes, boolean highlights) {
    this(kind, texelsPerMetre, megabytes, highlights, NOISE);
  }

  public LightStore {
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

  /** Whether light is stored in pictures. */
  public boolean inTextures() {
    return kind == Kind.TEXTURES;
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new IllegalArgumentException(otherwise);
    }
  }
}
