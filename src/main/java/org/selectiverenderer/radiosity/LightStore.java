package org.selectiverenderer.radiosity;

import java.util.OptionalDouble;

/**
 * Where light is stored.
 *
 * @param kind pictures, or colours at the vertices
 * @param texelsPerMetre of surfaces as large as a room's; empty for as many as the budget allows,
 *     up to a default
 * @param megabytes of all pictures together in memory, at most: three bytes a texel, 2^20 bytes
 *     each; their files are smaller
 * @param highlights whether shapes that shine keep their highlights, by lights that stay on
 */
public record LightStore(
    Kind kind, OptionalDouble texelsPerMetre, double megabytes, boolean highlights) {
  /** Pictures or vertices. */
  public enum Kind {
    TEXTURES,
    VERTICES
  }

  private static final double BUDGET = 24;

  /** Pictures, as fine as the budget allows. */
  public static final LightStore DEFAULT =
      new LightStore(Kind.TEXTURES, OptionalDouble.empty(), BUDGET, true);

  /** Colours at the vertices. */
  public static final LightStore VERTICES =
      new LightStore(Kind.VERTICES, OptionalDouble.empty(), BUDGET, false);

  private static final double DENSEST = 10_000;
  private static final double SMALLEST = 0.01;

  /** Three numbers a texel of all pictures must be as many as an array has. */
  private static final double LARGEST = 2_000;

  public LightStore {
    texelsPerMetre.ifPresent(
        density ->
            require(
                density > 0 && density <= DENSEST,
                "the texels per metre must be above 0 and at most 10000"));
    require(
        megabytes >= SMALLEST && megabytes <= LARGEST,
        "the texture budget must be from 0.01 to 2000 megabytes");
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
