package org.selectiverenderer.radiosity;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;
import org.selectiverenderer.radiosity.bake.VertexGatherer;
import org.selectiverenderer.radiosity.bake.VertexLight;
import org.selectiverenderer.radiosity.bake.VertexLitScene;
import org.selectiverenderer.radiosity.mesh.AdaptiveSubdivision;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.mesh.RadiosityMesh;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.TwoSidedLightSelector;

/**
 * Bakes the light of a scene to vertices: solves on patches, subdivides the mesh adaptively and
 * gathers irradiance at its vertices.
 */
final class VertexLightBaker {
  /** Rays per vertex in the rough gathering by which it is decided where to divide. */
  private static final int ROUGH_RAYS = 32;

  private static final int ROUGH_LAMP_EVERY = 2;

  /** One in this many gathering rays of a vertex is accompanied by shadow rays to the lamps. */
  private static final int LAMP_EVERY = 4;

  /** Factor of the rays at vertices of divided surfaces. */
  private static final int DIVIDED = 4;

  /**
   * Least and largest number of facets of the fine mesh on which interpolation errors are measured.
   */
  private static final int LEAST_FINE = 50_000;

  private static final int MOST_FINE = 200_000;

  /** Interpolation error, as a share of display white, below which a facet is not divided. */
  private static final double EVEN_ENOUGH = 0.02;

  private final RadiositySettings settings;
  private final RadiosityProgress progress;

  public VertexLightBaker(RadiositySettings settings, RadiosityProgress progress) {
    this.settings = settings;
    this.progress = progress;
  }

  /**
   * Lights a scene. If the work is cancelled, the last complete iteration lights it.
   *
   * @param each receives the solution after every iteration
   * @throws RadiosityException if the scene cannot be lit as asked for, before the long work, or if
   *     it is cancelled before the first iteration is complete
   */
  public VertexLitScene light(RadiosityScene scene, Consumer<RadiositySolution> each)
      throws RadiosityException {
    SubdivisionPlan plan = SubdivisionPlan.of(scene, settings);
    RadiositySolveStage.checkMemory(scene, plan);
    RadiositySolveStage iterations = RadiositySolveStage.of(scene, plan, settings, progress, each);
    RadiositySolution solution = iterations.solution();
    ReinhardToneMapping curve = ReinhardToneMapping.of(scene, solution, settings.exposure());
    TwoSidedLightSelector sides = TwoSidedLightSelector.of(scene, solution, settings.seed());
    long rays = iterations.rays();
    Map<Integer, List<Facet>> divided = new HashMap<>();
    for (SubdivisionPlan.Region region : plan.regions()) {
      rays += divide(scene, solution, sides, curve, plan, region, divided);
    }
    RadiosityMesh facets = RadiosityMesh.of(scene, divided);
    int count = settings.regather() ? settings.rays() : Math.min(settings.rays(), ROUGH_RAYS);
    VertexLight light =
        new VertexGatherer(
                scene,
                solution,
                sides,
                facets,
                new VertexGatherer.Effort(
                    count, DIVIDED * count, LAMP_EVERY, settings.regather(), settings.seed()))
            .gather(progress, RadiosityProgress.Stage.GATHERING);
    return new VertexLitScene(scene, facets, light, solution, curve, rays + light.rays());
  }

  /** Divides a region; returns the number of rays that this took. */
  private long divide(
      RadiosityScene scene,
      RadiositySolution solution,
      TwoSidedLightSelector sides,
      ReinhardToneMapping curve,
      SubdivisionPlan plan,
      SubdivisionPlan.Region region,
      Map<Integer, List<Facet>> divided)
      throws RadiosityException {
    AdaptiveSubdivision subdivision =
        new AdaptiveSubdivision(
            scene, region.bodies(), region.polygons(), plan.minMesh(), plan.maxMesh());
    subdivision.join();
    DisplayValues rough = gather(scene, solution, sides, curve, region, subdivision);
    subdivision.light(rough.values());
    if (!region.exact()) {
      subdivision.toSize();
    }
    AdaptiveSubdivision fine =
        subdivision.copy(Math.max(LEAST_FINE, Math.min(MOST_FINE, 2 * region.polygons())));
    fine.toFinest();
    DisplayValues light = gather(scene, solution, sides, curve, region, fine);
    subdivision.toLight(fine, light.values(), region.exact() ? 0 : EVEN_ENOUGH);
    plan.require(region, subdivision);
    divided.putAll(subdivision.facets());
    return rough.rays() + light.rays();
  }

  /**
   * Display values at the corners of a region's facets, by which it is decided where to divide.
   *
   * @param values shares of display white by body and corner
   */
  private record DisplayValues(Map<Integer, double[]> values, long rays) {}

  private DisplayValues gather(
      RadiosityScene scene,
      RadiositySolution solution,
      TwoSidedLightSelector sides,
      ReinhardToneMapping curve,
      SubdivisionPlan.Region region,
      AdaptiveSubdivision subdivision) {
    Map<Integer, List<Facet>> now = subdivision.facets();
    RadiosityMesh facets =
        RadiosityMesh.of(scene.only(region.bodies()), renumbered(now, region.bodies()));
    VertexLight light =
        new VertexGatherer(
                scene,
                solution,
                sides,
                facets,
                new VertexGatherer.Effort(
                    ROUGH_RAYS, ROUGH_RAYS, ROUGH_LAMP_EVERY, true, settings.seed()))
            .gather(progress, RadiosityProgress.Stage.SUBDIVISION);
    return new DisplayValues(values(region.bodies(), facets, light, curve), light.rays());
  }

  private static Map<Integer, List<Facet>> renumbered(
      Map<Integer, List<Facet>> facets, List<Integer> bodies) {
    Map<Integer, List<Facet>> own = new HashMap<>();
    for (int i = 0; i < bodies.size(); i++) {
      own.put(i, facets.getOrDefault(bodies.get(i), new ArrayList<>()));
    }
    return own;
  }

  /**
   * Returns the display value, as a share of white, that a light grey surface would have at each
   * corner, by body.
   */
  private static Map<Integer, double[]> values(
      List<Integer> bodies, RadiosityMesh facets, VertexLight light, ReinhardToneMapping curve) {
    double grey = 0.6;
    double[] bright = new double[facets.vertices()];
    for (int vertex = 0; vertex < bright.length; vertex++) {
      float[] e = light.irradiance();
      double luminance =
          grey
              / Math.PI
              * Photometry.luminance(e[3 * vertex], e[3 * vertex + 1], e[3 * vertex + 2]);
      bright[vertex] = Photometry.display(curve.share(luminance));
    }
    Map<Integer, double[]> values = new HashMap<>();
    for (int i = 0; i < bodies.size(); i++) {
      int first = 3 * facets.firstOfBody()[i];
      double[] own = new double[3 * facets.firstOfBody()[i + 1] - first];
      for (int k = 0; k < own.length; k++) {
        own[k] = bright[facets.vertexOf()[first + k]];
      }
      values.put(bodies.get(i), own);
    }
    return values;
  }
}
