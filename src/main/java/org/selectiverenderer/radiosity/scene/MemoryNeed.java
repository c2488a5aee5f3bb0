package org.selectiverenderer.radiosity.scene;

import java.util.Locale;

/**
 * What the parts of the work take of Java's memory, told before each starts. Of what may be used a
 * part gets a share, since others keep theirs meanwhile; bytes were measured.
 */
public final class MemoryNeed {
  /** For a triangle: its corners, box, tree, facets, vertices and text. */
  private static final long TRIANGLE = 700;

  /** For a patch besides its rays. */
  private static final long PATCH = 250;

  /** For a ray of a patch: what it met. */
  private static final long RAY = 4;

  /** For a facet while it may be divided. */
  private static final long FACET = 1_200;

  /** For a texel while light is gathered: its place, its light, its picture. */
  private static final long TEXEL = 48;

  private static final double ALL = 1;

  /** The scene itself is in the rest. */
  private static final double BESIDE_SCENE = 0.8;

  /** The scene and its patches are in the rest. */
  private static final double BESIDE_PATCHES = 0.6;

  private MemoryNeed() {}

  /**
   * The scene itself.
   *
   * @throws UnlitSceneException if there is not enough
   */
  static void ofTriangles(int count) throws UnlitSceneException {
    check((double) TRIANGLE * count, ALL, "lighting %d triangles takes".formatted(count), "");
  }

  /**
   * What light is passed on by, and what is divided for it.
   *
   * @param patches of the scene, and rays of each
   * @param facets of the largest region
   * @param made what they come from, as a sentence's beginning with its verb
   * @throws UnlitSceneException if there is not enough
   */
  public static void ofPatches(double patches, int rays, double facets, String made)
      throws UnlitSceneException {
    check(
        patches * (RAY * rays + PATCH) + facets * FACET,
        BESIDE_SCENE,
        "%s %.0f patches and up to %.0f polygons, which take".formatted(made, patches, facets),
        "raise --max-mesh, lower --max-polygons, or ");
  }

  /**
   * Light in pictures.
   *
   * @throws UnlitSceneException if there is not enough
   */
  public static void ofTexels(long count) throws UnlitSceneException {
    check(
        (double) TEXEL * count,
        BESIDE_PATCHES,
        "light in textures takes",
        "lower --texture-budget, or ");
  }

  private static void check(double bytes, double share, String what, String remedy)
      throws UnlitSceneException {
    double there = share * Runtime.getRuntime().maxMemory();
    if (bytes > there) {
      throw new UnlitSceneException(
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
