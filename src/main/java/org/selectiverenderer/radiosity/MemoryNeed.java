package org.selectiverenderer.radiosity;

import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;

/** What the long work will take of Java's memory, told before it starts. */
final class MemoryNeed {
  /** Of a patch besides its rays, and of a facet while it may be divided; measured, bytes. */
  private static final long PATCH = 250;

  private static final long FACET = 1_200;

  /** Of the memory that may be used: the scene itself is in the rest. */
  private static final double SHARE = 0.8;

  /** Patches of one triangle: those of 100 parts to an edge. */
  private static final double MOST_PARTS = 10_000;

  private MemoryNeed() {}

  /**
   * @param length of a patch's sides, metres
   * @param rays per patch
   * @throws UnlitSceneException if there is not enough
   */
  static void check(LightScene scene, MeshPlan plan, double length, int rays)
      throws UnlitSceneException {
    double patches = patches(scene, length);
    double facets = 0;
    for (MeshPlan.Region region : plan.regions()) {
      facets = Math.max(facets, region.polygons());
    }
    double bytes = patches * (4.0 * rays + PATCH) + facets * FACET;
    long most = Runtime.getRuntime().maxMemory();
    if (bytes > SHARE * most) {
      throw new UnlitSceneException(
          "a maximum mesh size of %s m makes %.0f patches and up to %.0f polygons, which take about"
                  .formatted(RadiositySettings.shortest(plan.maxMesh()), patches, facets)
              + " %.0f MB of memory, more than Java's %d MB; raise --max-mesh, lower"
                  .formatted(bytes / (1 << 20), most >> 20)
              + " --max-polygons, or give Java more with SELECTIVE_RENDERER_JAVA_OPTS=-Xmx4g");
    }
  }

  /** Most that there will be: right-angled halves of squares with this side as longest. */
  private static double patches(LightScene scene, double length) {
    double[] normal = new double[3];
    double sum = 0;
    for (int i = 0; i < scene.triangles().count(); i++) {
      double area = scene.triangles().normal(i, normal);
      double parts = Math.min(MOST_PARTS, 4 * area / (length * length));
      if (parts > 1) {
        sum += scene.triangles().twoSided()[i] ? 2 * parts : parts;
      }
    }
    return sum;
  }
}
