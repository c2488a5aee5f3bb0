package org.selectiverenderer.radiosity.texel;

import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Gathers irradiance at texels: direct light at every texel, indirect light at irradiance records
 * between which it is interpolated.
 */
public final class TexelGatherer {
  /** Shares of the progress after which direct light and then indirect light are known. */
  private static final double LAMPS = 0.4;

  private static final double SURFACES = 0.95;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final Atlas atlas;
  private final Effort effort;

  /**
   * The sampling effort.
   *
   * @param rays number of rays of an irradiance record, at least 8
   * @param lampRays largest number of shadow rays to each lamp from a texel in a penumbra
   * @param noise standard error of a record, as a share of its light, above which it gets more rays
   *     while the budget of rays lasts
   * @param regather whether indirect light is gathered by rays, or taken from the patches
   */
  public record Effort(int rays, int lampRays, double noise, boolean regather, int seed) {
    public static Effort of(int rays, double noise, boolean regather, int seed) {
      return new Effort(Math.max(8, rays), 64, noise, regather, seed);
    }
  }

  public TexelGatherer(
      RadiosityScene scene, RadiositySolution solution, Atlas atlas, Effort effort) {
    this.scene = scene;
    this.solution = solution;
    this.atlas = atlas;
    this.effort = effort;
  }

  /**
   * Gathers the irradiance at all texels. If the work is cancelled, the rest is taken from the
   * solution's patches.
   */
  public IrradianceAtlas gather(TexelSelection choice, RadiosityProgress progress) {
    return gather(choice, progress, null);
  }

  /**
   * Gathers the irradiance at all texels and reports an intermediate result.
   *
   * @param each receives the intermediate light, for previews; it must not keep it
   */
  public IrradianceAtlas gather(
      TexelSelection choice,
      RadiosityProgress progress,
      @org.jspecify.annotations.Nullable Consumer<IrradianceAtlas> each) {
    TexelIndex texels =
        new TexelIndex(atlas, choice, TwoSidedLightSelector.of(scene, solution, effort.seed()));
    PatchLightLookup patches = new PatchLightLookup(scene, solution, texels);
    DirectLightPass lamps =
        new DirectLightPass(scene, solution, texels, effort.lampRays(), effort.seed());
    float[] direct =
        lamps.gather(progress, done -> progress.at(RadiosityProgress.Stage.TEXELS, LAMPS * done));
    long rays = lamps.rays();
    if (direct == null) {
      return pages(texels, choice, patches.all(), false, rays, TexelNoiseStatistics.NONE);
    }
    TexelRayCaster.Sets sets = TexelRayCaster.Sets.of(effort.rays(), effort.seed());
    TexelOcclusionPass nearby =
        TexelOcclusionPass.look(scene, solution, texels, direct, sets, progress);
    rays += nearby.rays();
    if (each != null) {
      float[] rough = direct.clone();
      patches.addIndirect(rough);
      each.accept(pages(texels, choice, rough, false, rays, TexelNoiseStatistics.NONE));
    }
    if (!effort.regather()) {
      patches.addIndirect(direct);
      return pages(texels, choice, direct, true, rays, TexelNoiseStatistics.NONE);
    }
    IrradianceCachePass surfaces =
        new IrradianceCachePass(scene, solution, texels, nearby, direct, sets, effort.noise());
    boolean whole =
        surfaces.gather(
            progress,
            done -> progress.at(RadiosityProgress.Stage.TEXELS, LAMPS + (SURFACES - LAMPS) * done));
    rays += surfaces.rays();
    if (!whole) {
      patches.addIndirect(direct);
      return pages(texels, choice, direct, false, rays, TexelNoiseStatistics.NONE);
    }
    TexelNoiseStatistics noise =
        new IrradianceInterpolationPass(scene, solution, texels, surfaces).addTo(direct);
    progress.at(RadiosityProgress.Stage.TEXELS, 1);
    return pages(texels, choice, direct, true, rays, noise);
  }

  private IrradianceAtlas pages(
      TexelIndex texels,
      TexelSelection choice,
      float[] light,
      boolean complete,
      long rays,
      TexelNoiseStatistics noise) {
    List<float[]> pages = texels.pages(light);
    java.util.stream.IntStream.range(0, pages.size())
        .parallel()
        .forEach(
            page -> TexelHoleFilling.inCharts(texels.map(page), pages.get(page), texels, page));
    choice.rest(pages);
    java.util.stream.IntStream.range(0, pages.size())
        .parallel()
        .forEach(page -> TexelHoleFilling.gutters(texels.map(page), pages.get(page)));
    return new IrradianceAtlas(atlas, pages, complete, rays, noise);
  }
}
