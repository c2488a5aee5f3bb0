package org.selectiverenderer.radiosity.texel;

import java.util.List;
import java.util.function.Consumer;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Gathers irradiance at texels: direct light at every texel, indirect light at irradiance records
 * between which it is interpolated.
 */
public final class TexelGatherer {
  /** Shares of the progress after which direct light and then indirect light are known. */
  private static final double LAMPS = 0.4;

  private static final double SURFACES = 0.95;

  private final LightScene scene;
  private final Solution solution;
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

  public TexelGatherer(LightScene scene, Solution solution, Atlas atlas, Effort effort) {
    this.scene = scene;
    this.solution = solution;
    this.atlas = atlas;
    this.effort = effort;
  }

  /**
   * Gathers the irradiance at all texels. If the work is cancelled, the rest is taken from the
   * solution's patches.
   */
  public LightPages gather(TexelChoice choice, WorkProgress progress) {
    return gather(choice, progress, null);
  }

  /**
   * Gathers the irradiance at all texels and reports an intermediate result.
   *
   * @param each receives the intermediate light, for previews; it must not keep it
   */
  public LightPages gather(
      TexelChoice choice,
      WorkProgress progress,
      @org.jspecify.annotations.Nullable Consumer<LightPages> each) {
    Texels texels = new Texels(atlas, choice, SeenSides.of(scene, solution, effort.seed()));
    PatchLight patches = new PatchLight(scene, solution, texels);
    DirectPass lamps = new DirectPass(scene, solution, texels, effort.lampRays(), effort.seed());
    float[] direct =
        lamps.gather(progress, done -> progress.at(WorkProgress.Stage.TEXELS, LAMPS * done));
    long rays = lamps.rays();
    if (direct == null) {
      return pages(texels, choice, patches.all(), false, rays, TexelNoise.NONE);
    }
    TexelRays.Sets sets = TexelRays.Sets.of(effort.rays(), effort.seed());
    NearbyPass nearby = NearbyPass.look(scene, solution, texels, direct, sets, progress);
    rays += nearby.rays();
    if (each != null) {
      float[] rough = direct.clone();
      patches.addIndirect(rough);
      each.accept(pages(texels, choice, rough, false, rays, TexelNoise.NONE));
    }
    if (!effort.regather()) {
      patches.addIndirect(direct);
      return pages(texels, choice, direct, true, rays, TexelNoise.NONE);
    }
    IndirectPass surfaces =
        new IndirectPass(scene, solution, texels, nearby, direct, sets, effort.noise());
    boolean whole =
        surfaces.gather(
            progress,
            done -> progress.at(WorkProgress.Stage.TEXELS, LAMPS + (SURFACES - LAMPS) * done));
    rays += surfaces.rays();
    if (!whole) {
      patches.addIndirect(direct);
      return pages(texels, choice, direct, false, rays, TexelNoise.NONE);
    }
    TexelNoise noise = new IndirectBetween(scene, solution, texels, surfaces).addTo(direct);
    progress.at(WorkProgress.Stage.TEXELS, 1);
    return pages(texels, choice, direct, true, rays, noise);
  }

  private LightPages pages(
      Texels texels,
      TexelChoice choice,
      float[] light,
      boolean complete,
      long rays,
      TexelNoise noise) {
    List<float[]> pages = texels.pages(light);
    java.util.stream.IntStream.range(0, pages.size())
        .parallel()
        .forEach(page -> ChartFilling.inCharts(texels.map(page), pages.get(page), texels, page));
    choice.rest(pages);
    java.util.stream.IntStream.range(0, pages.size())
        .parallel()
        .forEach(page -> ChartFilling.gutters(texels.map(page), pages.get(page)));
    return new LightPages(atlas, pages, complete, rays, noise);
  }
}
