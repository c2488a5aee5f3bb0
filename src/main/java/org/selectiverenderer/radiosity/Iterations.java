package org.selectiverenderer.radiosity;

import java.util.function.Consumer;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.MemoryNeed;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.solve.LightPatches;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.solve.Solver;
import org.selectiverenderer.radiosity.solve.Transport;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * The light on patches, wherever it is stored in the end.
 *
 * @param rays cast for it
 */
record Iterations(Solution solution, long rays) {
  /** Sides of patches, as a share of the maximum mesh size. */
  private static final double PATCH = 0.4;

  /** Rays per patch, and lamp places per patch. */
  private static final int PATCH_RAYS = 64;

  private static final int PATCH_LAMP_PLACES = 8;

  /**
   * The share of them where texels take their light from elsewhere: see {@link Transport.Effort}.
   */
  private static final int FEWER = 4;

  /** Patches of one triangle: those of 100 parts to an edge. */
  private static final double MOST_PARTS = 10_000;

  /**
   * Passes light on until the wanted share of the energy is distributed. If it is cancelled, the
   * last complete iteration is the result.
   *
   * @param each hears the solution after every iteration
   * @throws UnlitSceneException if there is not enough memory, before the long work, or if it is
   *     cancelled before the first iteration is complete
   */
  static Iterations of(
      LightScene scene,
      MeshPlan plan,
      RadiositySettings settings,
      WorkProgress progress,
      Consumer<Solution> each)
      throws UnlitSceneException {
    LightPatches patches = new LightPatches(scene, PATCH * plan.maxMesh());
    boolean shared = settings.regather() && settings.store().inTextures();
    Transport.Effort effort =
        new Transport.Effort(PATCH_RAYS, PATCH_LAMP_PLACES, shared ? FEWER : 1);
    Transport transport = Transport.find(scene, patches, effort, settings.seed(), progress);
    Solution solution =
        new Solver(scene, transport)
            .solve(settings.iterations(), settings.quality(), progress, each);
    if (solution.balances().isEmpty()) {
      throw new UnlitSceneException(
          "cancelled before the first iteration was complete; nothing is written");
    }
    return new Iterations(solution, transport.cast());
  }

  /**
   * Whether there is memory for it.
   *
   * @throws UnlitSceneException if there is not enough
   */
  static void checkMemory(LightScene scene, MeshPlan plan) throws UnlitSceneException {
    double facets = 0;
    for (MeshPlan.Region region : plan.regions()) {
      facets = Math.max(facets, region.polygons());
    }
    MemoryNeed.ofPatches(
        patches(scene, PATCH * plan.maxMesh()),
        PATCH_RAYS,
        facets,
        "a maximum mesh size of %s m makes".formatted(RadiositySettings.shortest(plan.maxMesh())));
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
