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

/** Lights a scene: the whole way from triangles to light at vertices. */
final class Radiosity {
  /** Rays per vertex while it is decided where to divide. */
  private static final int ROUGH_RAYS = 32;

  private static final int ROUGH_LAMP_EVERY = 2;

  /** Of so many rays gathered at a vertex one is accompanied by shadow rays to the lamps. */
  private static final int LAMP_EVERY = 4;

  /** So many times the rays are gathered at vertices of divided surfaces. */
  private static final int DIVIDED = 4;

  /** Facets of the mesh on which errors are measured: at least and at most. */
  private static final int LEAST_FINE = 50_000;

  private static final int MOST_FINE = 200_000;

  /** Errors in shares of white that are not worth dividing a facet. */
  private static final double EVEN_ENOUGH = 0.02;

  private final RadiositySettings settings;
  private final WorkProgress progress;

  public Radiosity(RadiositySettings settings, WorkProgress progress) {
    this.settings = settings;
    this.progress = progress;
  }

  /**
   * Lights a scene. If it is cancelled, the last complete iteration is what it is lit by.
   *
   * @param each hears the solution after every iteration
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

  /** Divides a region; returns the rays that it took. */
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
   * Light for deciding where to divide.
   *
   * @param values shares of white by body and corner
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

  /** How bright a light grey surface would be shown, by body and corner. */
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
