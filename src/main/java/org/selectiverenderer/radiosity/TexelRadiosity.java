package org.selectiverenderer.radiosity;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasMaker;
import org.selectiverenderer.radiosity.atlas.AtlasSettings;
import org.selectiverenderer.radiosity.bake.ShiningImages;
import org.selectiverenderer.radiosity.bake.TexelScene;
import org.selectiverenderer.radiosity.bake.ToneCurve;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.mesh.Subdivision;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.texel.LightPages;
import org.selectiverenderer.radiosity.texel.SharedTexels;
import org.selectiverenderer.radiosity.texel.TexelGatherer;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Bakes the light of a scene to lightmaps: solves on patches, builds the atlas and gathers
 * irradiance at its texels.
 */
final class TexelRadiosity {
  private final RadiositySettings settings;
  private final WorkProgress progress;
  private final Problems problems;

  /**
   * @param problems receives a note for each surface whose texels are coarser than requested
   */
  TexelRadiosity(RadiositySettings settings, WorkProgress progress, Problems problems) {
    this.settings = settings;
    this.progress = progress;
    this.problems = problems;
  }

  /**
   * Lights a scene. If the work is cancelled, the last complete iteration lights it.
   *
   * @param fileOf by body: the number of the file that it is written to, or {@link
   *     AtlasMaker#NO_GROUP}
   * @param each receives the solution after every iteration
   * @throws UnlitSceneException if the scene cannot be lit as asked for, before the long work, or
   *     if it is cancelled before the first iteration is complete
   */
  TexelScene light(LightScene scene, int[] fileOf, Consumer<Solution> each)
      throws UnlitSceneException {
    return light(scene, fileOf, each, null);
  }

  /**
   * Lights a scene and reports an intermediate result.
   *
   * @param rough receives the light at texels before indirect light is gathered, or null
   */
  TexelScene light(
      LightScene scene,
      int[] fileOf,
      Consumer<Solution> each,
      @Nullable BiConsumer<LightPages, ToneCurve> rough)
      throws UnlitSceneException {
    MeshPlan plan = MeshPlan.of(scene, settings);
    Iterations.checkMemory(scene, plan);
    Map<Integer, List<Facet>> divided = divided(scene, plan);
    double[] wished =
        settings.store().highlights()
            ? ShiningImages.texels(scene)
            : new double[scene.bodies().size()];
    Atlas atlas = new AtlasMaker(atlasSettings(), problems).make(scene, fileOf, wished);
    Iterations iterations = Iterations.of(scene, plan, settings, progress, each);
    Solution solution = iterations.solution();
    TexelGatherer.Effort effort =
        TexelGatherer.Effort.of(
            settings.rays(), settings.store().noise() / 100, settings.regather(), settings.seed());
    ToneCurve curve = ToneCurve.of(scene, solution, settings.exposure());
    LightPages pages =
        new TexelGatherer(scene, solution, atlas, effort)
            .gather(
                SharedTexels.find(scene, atlas, progress),
                progress,
                rough == null ? null : light -> rough.accept(light, curve));
    return new TexelScene(scene, pages, divided, solution, curve, iterations.rays() + pages.rays());
  }

  private AtlasSettings atlasSettings() {
    LightStore store = settings.store();
    return new AtlasSettings(
        store.texelsPerMetre(),
        Math.round(store.megabytes() * (1 << 20)),
        AtlasSettings.DEFAULT.largestPage());
  }

  /**
   * Subdivides the surfaces for which the scene asks a number of polygons; the longest edges are
   * halved first.
   */
  private static Map<Integer, List<Facet>> divided(LightScene scene, MeshPlan plan)
      throws UnlitSceneException {
    Map<Integer, List<Facet>> divided = new HashMap<>();
    for (MeshPlan.Region region : plan.regions()) {
      Subdivision subdivision =
          new Subdivision(
              scene, region.bodies(), region.polygons(), plan.minMesh(), plan.maxMesh());
      subdivision.join();
      subdivision.toLength();
      plan.require(region, subdivision);
      divided.putAll(subdivision.facets());
    }
    return divided;
  }
}
