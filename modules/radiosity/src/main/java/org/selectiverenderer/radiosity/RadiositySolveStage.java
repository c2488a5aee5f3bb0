package org.selectiverenderer.radiosity;

import java.util.function.Consumer;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.MemoryEstimator;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.MonteCarloFormFactors;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.solve.RadiositySolver;
import org.selectiverenderer.radiosity.solve.SurfacePatches;

/**
 * The radiosity solution on patches, from which light at vertices and light at texels both start,
 * and the cost of finding it.
 *
 * @param rays number of rays cast for the form factors and for direct light
 */
record RadiositySolveStage(RadiositySolution solution, long rays) {
  /** Side of a patch, as a share of the maximum mesh size. */
  private static final double PATCH = 0.4;

  /** Rays per patch, and sample points of each lamp per patch. */
  private static final int PATCH_RAYS = 64;

  private static final int PATCH_LAMP_PLACES = 8;

  /**
   * Divides both numbers for versions whose texels copy the light of the reference version: see
   * {@link MonteCarloFormFactors.Effort}.
   */
  private static final int FEWER = 4;

  /** Upper bound of the patches of one triangle: 100 parts to an edge, squared. */
  private static final double MOST_PARTS = 10_000;

  /**
   * Iterates until the requested share of the energy is distributed. If the work is cancelled, the
   * last complete iteration is the result.
   *
   * @param each receives the solution after every iteration
   * @throws RadiosityException if there is not enough memory, before the long work, or if it is
   *     cancelled before the first iteration is complete
   */
  static RadiositySolveStage of(
      RadiosityScene scene,
      SubdivisionPlan plan,
      RadiositySettings settings,
      RadiosityProgress progress,
      Consumer<RadiositySolution> each)
      throws RadiosityException {
    SurfacePatches patches = new SurfacePatches(scene, PATCH * plan.maxMesh());
    boolean shared = settings.regather() && settings.store().inTextures();
    MonteCarloFormFactors.Effort effort =
        new MonteCarloFormFactors.Effort(PATCH_RAYS, PATCH_LAMP_PLACES, shared ? FEWER : 1);
    MonteCarloFormFactors transport =
        MonteCarloFormFactors.find(scene, patches, effort, settings.seed(), progress);
    RadiositySolution solution =
        new RadiositySolver(scene, transport)
            .solve(settings.iterations(), settings.quality(), progress, each);
    if (solution.balances().isEmpty()) {
      throw new RadiosityException(
          "cancelled before the first iteration was complete; nothing is written");
    }
    return new RadiositySolveStage(solution, transport.cast());
  }

  /**
   * Checks that the patches and the mesh fit into Java's memory.
   *
   * @throws RadiosityException if there is not enough
   */
  static void checkMemory(RadiosityScene scene, SubdivisionPlan plan) throws RadiosityException {
    double facets = 0;
    for (SubdivisionPlan.Region region : plan.regions()) {
      facets = Math.max(facets, region.polygons());
    }
    MemoryEstimator.ofPatches(
        patches(scene, PATCH * plan.maxMesh()),
        PATCH_RAYS,
        facets,
        "a maximum mesh size of %s m makes".formatted(RadiositySettings.shortest(plan.maxMesh())));
  }

  /**
   * Returns an upper bound of the number of patches: triangles are counted as right-angled halves
   * of squares whose diagonal has this length, metres.
   */
  private static double patches(RadiosityScene scene, double length) {
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
