package org.selectiverenderer.radiosity;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasBuilder;
import org.selectiverenderer.radiosity.atlas.AtlasSettings;
import org.selectiverenderer.radiosity.bake.GlossySurfaceFinder;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;
import org.selectiverenderer.radiosity.mesh.AdaptiveSubdivision;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;
import org.selectiverenderer.radiosity.texel.IrradianceAtlas;
import org.selectiverenderer.radiosity.texel.TexelGatherer;
import org.selectiverenderer.radiosity.texel.VersionLightTransfer;

/**
 * Bakes the light of a scene to lightmaps: solves on patches, builds the atlas and gathers
 * irradiance at its texels.
 */
final class LightmapBaker {
  private final RadiositySettings settings;
  private final RadiosityProgress progress;
  private final ProblemCollector problems;

  /**
   * @param problems receives a note for each surface whose texels are coarser than requested
   */
  LightmapBaker(RadiositySettings settings, RadiosityProgress progress, ProblemCollector problems) {
    this.settings = settings;
    this.progress = progress;
    this.problems = problems;
  }

  /**
   * Lights a scene. If the work is cancelled, the last complete iteration lights it.
   *
   * @param fileOf by body: the number of the file that it is written to, or {@link
   *     AtlasBuilder#NO_GROUP}
   * @param each receives the solution after every iteration
   * @throws RadiosityException if the scene cannot be lit as asked for, before the long work, or if
   *     it is cancelled before the first iteration is complete
   */
  LightmappedScene light(RadiosityScene scene, int[] fileOf, Consumer<RadiositySolution> each)
      throws RadiosityException {
    return light(scene, fileOf, each, null);
  }

  /**
   * Lights a scene and reports an intermediate result.
   *
   * @param rough receives the light at texels before indirect light is gathered, or null
   */
  LightmappedScene light(
      RadiosityScene scene,
      int[] fileOf,
      Consumer<RadiositySolution> each,
      @Nullable BiConsumer<IrradianceAtlas, ReinhardToneMapping> rough)
      throws RadiosityException {
    SubdivisionPlan plan = SubdivisionPlan.of(scene, settings);
    RadiositySolveStage.checkMemory(scene, plan);
    Map<Integer, List<Facet>> divided = divided(scene, plan);
    double[] wished =
        settings.store().highlights()
            ? GlossySurfaceFinder.texels(scene)
            : new double[scene.bodies().size()];
    Atlas atlas = new AtlasBuilder(atlasSettings(), problems).make(scene, fileOf, wished);
    RadiositySolveStage iterations = RadiositySolveStage.of(scene, plan, settings, progress, each);
    RadiositySolution solution = iterations.solution();
    TexelGatherer.Effort effort =
        TexelGatherer.Effort.of(
            settings.rays(), settings.store().noise() / 100, settings.regather(), settings.seed());
    ReinhardToneMapping curve = ReinhardToneMapping.of(scene, solution, settings.exposure());
    IrradianceAtlas pages =
        new TexelGatherer(scene, solution, atlas, effort)
            .gather(
                VersionLightTransfer.find(scene, atlas, progress),
                progress,
                rough == null ? null : light -> rough.accept(light, curve));
    return new LightmappedScene(
        scene, pages, divided, solution, curve, iterations.rays() + pages.rays());
  }

  private AtlasSettings atlasSettings() {
    LightStorageSettings store = settings.store();
    return new AtlasSettings(
        store.texelsPerMetre(),
        Math.round(store.megabytes() * (1 << 20)),
        AtlasSettings.DEFAULT.largestPage());
  }

  /**
   * Subdivides the surfaces for which the scene asks a number of polygons; the longest edges are
   * halved first.
   */
  private static Map<Integer, List<Facet>> divided(RadiosityScene scene, SubdivisionPlan plan)
      throws RadiosityException {
    Map<Integer, List<Facet>> divided = new HashMap<>();
    for (SubdivisionPlan.Region region : plan.regions()) {
      AdaptiveSubdivision subdivision =
          new AdaptiveSubdivision(
              scene, region.bodies(), region.polygons(), plan.minMesh(), plan.maxMesh());
      subdivision.join();
      subdivision.toLength();
      plan.require(region, subdivision);
      divided.putAll(subdivision.facets());
    }
    return divided;
  }
}
