package org.selectiverenderer.radiosity;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.selectiverenderer.radiosity.bake.LitScene;
import org.selectiverenderer.radiosity.bake.ToneCurve;
import org.selectiverenderer.radiosity.bake.VertexGatherer;
import org.selectiverenderer.radiosity.bake.VertexLight;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.mesh.Facets;
import org.selectiverenderer.radiosity.mesh.Subdivision;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.texel.SeenSides;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Bakes the light of a scene to vertices: solves on patches, subdivides the mesh adaptively and
 * gathers irradiance at its vertices.
 */
final class Radiosity {
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
  private final WorkProgress progress;

  public Radiosity(RadiositySettings settings, WorkProgress progress) {
    this.settings = settings;
    this.progress = progress;
  }

  /**
   * Lights a scene. If the work is cancelled, the last complete iteration lights it.
   *
   * @param each receives the solution after every iteration
   * @throws UnlitSceneException if the scene cannot be lit as asked for, before the long work, or
   *     if it is cancelled before the first iteration is complete
   */
  public LitScene light(LightScene scene, Consumer<Solution> each) throws UnlitSceneException {
    MeshPlan plan = MeshPlan.of(scene, settings);
    Iterations.checkMemory(scene, plan);
    Iterations iterations = Iterations.of(scene, plan, settings, progress, each);
    Solution solution = iterations.solution();
    ToneCurve curve = ToneCurve.of(scene, solution, settings.exposure());
    SeenSides sides = SeenSides.of(scene, solution, settings.seed());
    long rays = iterations.rays();
    Map<Integer, List<Facet>> divided = new HashMap<>();
    for (MeshPlan.Region region : plan.regions()) {
      rays += divide(scene, solution, sides, curve, plan, region, divided);
    }
    Facets facets = Facets.of(scene, divided);
    int count = settings.regather() ? settings.rays() : Math.min(settings.rays(), ROUGH_RAYS);
    VertexLight light =
        new VertexGatherer(
                scene,
                solution,
                sides,
                facets,
                new VertexGatherer.Effort(
                    count, DIVIDED * count, LAMP_EVERY, settings.regather(), settings.seed()))
            .gather(progress, WorkProgress.Stage.GATHERING);
    return new LitScene(scene, facets, light, solution, curve, rays + light.rays());
  }

  /** Divides a region; returns the number of rays that this took. */
  private long divide(
      LightScene scene,
      Solution solution,
      SeenSides sides,
      ToneCurve curve,
      MeshPlan plan,
      MeshPlan.Region region,
      Map<Integer, List<Facet>> divided)
      throws UnlitSceneException {
    Subdivision subdivision =
        new Subdivision(scene, region.bodies(), region.polygons(), plan.minMesh(), plan.maxMesh());
    subdivision.join();
    Gathered rough = gather(scene, solution, sides, curve, region, subdivision);
    subdivision.light(rough.values());
    if (!region.exact()) {
      subdivision.toSize();
    }
    Subdivision fine =
        subdivision.copy(Math.max(LEAST_FINE, Math.min(MOST_FINE, 2 * region.polygons())));
    fine.toFinest();
    Gathered light = gather(scene, solution, sides, curve, region, fine);
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
  private record Gathered(Map<Integer, double[]> values, long rays) {}

  private Gathered gather(
      LightScene scene,
      Solution solution,
      SeenSides sides,
      ToneCurve curve,
      MeshPlan.Region region,
      Subdivision subdivision) {
    Map<Integer, List<Facet>> now = subdivision.facets();
    Facets facets = Facets.of(scene.only(region.bodies()), renumbered(now, region.bodies()));
    VertexLight light =
        new VertexGatherer(
                scene,
                solution,
                sides,
                facets,
                new VertexGatherer.Effort(
                    ROUGH_RAYS, ROUGH_RAYS, ROUGH_LAMP_EVERY, true, settings.seed()))
            .gather(progress, WorkProgress.Stage.SUBDIVISION);
    return new Gathered(values(region.bodies(), facets, light, curve), light.rays());
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
      List<Integer> bodies, Facets facets, VertexLight light, ToneCurve curve) {
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
