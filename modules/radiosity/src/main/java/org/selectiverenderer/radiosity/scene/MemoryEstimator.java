package org.selectiverenderer.radiosity.scene;

import java.util.Locale;

/**
 * Estimates the Java memory that each part of the computation takes, before it starts. Each part
 * may use a share of the maximum heap, since other parts keep theirs; the bytes per item were
 * measured.
 */
public final class MemoryEstimator {
  /** Bytes for a triangle: its corners, box, tree node, facets, vertices and text. */
  private static final long TRIANGLE = 700;

  /** Bytes for a patch besides its rays. */
  private static final long PATCH = 250;

  /** Bytes for a ray of a patch: the number of the patch that it hit. */
  private static final long RAY = 4;

  /** Bytes for a facet that may be divided. */
  private static final long FACET = 1_200;

  /** Bytes for a texel while light is gathered: its surface point, its light, its pixel. */
  private static final long TEXEL = 48;

  private static final double ALL = 1;

  /** Share of the heap besides the scene itself. */
  private static final double BESIDE_SCENE = 0.8;

  /** Share of the heap besides the scene and its patches. */
  private static final double BESIDE_PATCHES = 0.6;

  private MemoryEstimator() {}

  /**
   * Checks the memory for the scene itself.
   *
   * @throws RadiosityException if there is not enough
   */
  static void ofTriangles(int count) throws RadiosityException {
    check((double) TRIANGLE * count, ALL, "lighting %d triangles takes".formatted(count), "");
  }

  /**
   * Checks the memory for the patches and for the facets of the subdivision.
   *
   * @param patches number of patches, each with {@code rays}
   * @param facets number of facets of the largest region
   * @param made beginning of the message, with its verb: the setting that makes so many patches
   * @throws RadiosityException if there is not enough
   */
  public static void ofPatches(double patches, int rays, double facets, String made)
      throws RadiosityException {
    check(
        patches * (RAY * rays + PATCH) + facets * FACET,
        BESIDE_SCENE,
        "%s %.0f patches and up to %.0f polygons, which take".formatted(made, patches, facets),
        "raise --max-mesh, lower --max-polygons, or ");
  }

  /**
   * Checks the memory for lightmaps.
   *
   * @throws RadiosityException if there is not enough
   */
  public static void ofTexels(long count) throws RadiosityException {
    check(
        (double) TEXEL * count,
        BESIDE_PATCHES,
        "light in textures takes",
        "lower --texture-budget, or ");
  }

  private static void check(double bytes, double share, String what, String remedy)
      throws RadiosityException {
    double there = share * Runtime.getRuntime().maxMemory();
    if (bytes > there) {
      throw new RadiosityException(
          String.format(
              Locale.ROOT,
              "%s about %.0f MB of memory, more than Java's %.0f MB for it; %sgive Java more with"
                  + " SELECTIVE_RENDERER_JAVA_OPTS=-Xmx4g",
              what,
              megabytes(bytes),
              megabytes(there),
              remedy));
    }
  }

  private static double megabytes(double bytes) {
    return bytes / (1 << 20);
  }
}
