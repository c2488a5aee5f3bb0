package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.sampling.SobolPointSet;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Computes the direct irradiance from the lamps at every texel: the unshadowed irradiance in closed
 * form, times the visible share of the lamp. That share is estimated with many shadow rays at every
 * fourth texel of every fourth row, and with one ray at every other texel in between. Where all of
 * them agree, or the share changes slowly and the single rays agree with the interpolated share, it
 * is interpolated. Elsewhere each texel casts rays of its own, few of them in penumbras, and their
 * noise is filtered with the adjacent texels that have about the same share.
 */
final class DirectLightPass {
  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final LightVisibilityEstimator.Points points;
  private final char[] shares;

  /** Per texel: its visible share, before penumbras are filtered. */
  private final char[] found;

  /** Per texel: whether its share is filtered, since it comes of few rays or lies in a penumbra. */
  private final boolean[] noisy;

  private final float[] light;
  private final LongAdder rays = new LongAdder();

  DirectLightPass(
      RadiosityScene scene, RadiositySolution solution, TexelIndex texels, int most, int seed) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    points = LightVisibilityEstimator.Points.of(most, seed);
    shares = new char[texels.count()];
    found = new char[texels.count()];
    noisy = new boolean[texels.count()];
    light = new float[3 * texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  /** Returns the irradiance r, g, b of all texels, lx; null if the work was cancelled. */
  float @Nullable [] gather(RadiosityProgress progress, DoubleConsumer done) {
    TileLightCulling tiles = TileLightCulling.find(scene, solution, texels, points, progress, rays);
    int lamps = scene.lamps().size();
    for (int i = 0; i < lamps; i++) {
      int lamp = i;
      Arrays.fill(shares, LightVisibilityGrid.UNKNOWN);
      Arrays.fill(found, LightVisibilityGrid.UNKNOWN);
      Arrays.fill(noisy, false);
      boolean whole =
          each(tiles, lamp, progress, share -> {}, worker -> worker::probe)
              && each(
                  tiles,
                  lamp,
                  progress,
                  share -> done.accept((lamp + share) / lamps),
                  worker -> worker::find)
              && (scene.lamps().get(lamp).hard()
                  || each(tiles, lamp, progress, share -> {}, worker -> worker::even));
      if (!whole) {
        return null;
      }
    }
    return progress.cancelled() ? null : light;
  }

  private boolean each(
      TileLightCulling tiles,
      int lamp,
      RadiosityProgress progress,
      DoubleConsumer done,
      Function<Worker, IntConsumer> task) {
    return ParallelFor.run(
        texels.tiles(),
        64,
        progress,
        done,
        (from, to) -> {
          Worker worker = new Worker(lamp);
          IntConsumer work = task.apply(worker);
          for (int tile = from; tile < to; tile++) {
            if (tiles.has(tile, lamp)) {
              texels.each(tile, work);
            }
          }
          rays.add(worker.shadow.rays());
        });
  }

  /** The work of one thread on one lamp. */
  private final class Worker {
    private final int number;
    private final LightSource lamp;
    private final LightVisibilityEstimator shadow = new LightVisibilityEstimator(scene, points);
    private final UnshadowedLight unhidden = new UnshadowedLight(points.onTexel());
    private final TexelSurfacePoint place = new TexelSurfacePoint(scene, solution, texels);
    private final double[] open = new double[3];
    private final LightVisibilityGrid grid = new LightVisibilityGrid(texels, shares);
    private final LightVisibilityGrid around = new LightVisibilityGrid(texels, found);

    Worker(int number) {
      this.number = number;
      lamp = scene.lamps().get(number);
    }

    void probe(int texel) {
      grid.go(texel);
      boolean onGrid = grid.onGrid();
      if (!onGrid && grid.spared()) {
        return;
      }
      place.at(texel);
      double share =
          onGrid
              ? shadow.share(place, number, texel + 7919 * number)
              : shadow.one(place, number, grid.inCell(), grid.cell() + 7919 * number + 0x1234567);
      shares[texel] = LightVisibilityGrid.of(share);
    }

    /**
     * Finds the visible share of a texel and adds its light, unless the share has to be filtered
     * first.
     */
    void find(int texel) {
      place.at(texel);
      unhidden.of(lamp, place, open);
      if (!(open[0] + open[1] + open[2] > 0)) {
        return;
      }
      grid.go(texel);
      double share = known();
      boolean own = Double.isNaN(share);
      if (own) {
        share = rays(texel);
      }
      found[texel] = LightVisibilityGrid.of(share);
      noisy[texel] = !lamp.hard() && (own || LightVisibilityGrid.mixed(found[texel]));
      if (!noisy[texel]) {
        add(texel, share);
      }
    }

    /** Returns the share known from the grid; NaN if the texel needs rays of its own. */
    private double known() {
      if (grid.onGrid()) {
        return grid.settled() ? grid.known() : Double.NaN;
      }
      return grid.interpolate() ? grid.interpolated() : Double.NaN;
    }

    private double rays(int texel) {
      int turn = texel + 7919 * number;
      return Math.max(
          0,
          grid.onGrid() || grid.cornered() || lamp.hard()
              ? shadow.edge(place, number, turn)
              : shadow.small(place, number, turn));
    }

    private void add(int texel, double share) {
      for (int c = 0; c < 3; c++) {
        light[3 * texel + c] += (float) (share * open[c]);
      }
    }

    /**
     * Filters the share of a noisy texel: takes the mean over the adjacent texels that have about
     * the same share. This includes texels of a penumbra whose few rays agree by chance.
     */
    void even(int texel) {
      if (!noisy[texel]) {
        return;
      }
      around.go(texel);
      place.at(texel);
      unhidden.of(lamp, place, open);
      add(texel, around.meanOfAlike());
    }
  }

  /**
   * Computes the unshadowed irradiance of a lamp on a texel in closed form, at the texel's middle
   * where that represents the whole texel. Close to a lamp it does not: on a window's reveal the
   * light begins with a step in the lamp's plane and falls to a half within centimetres, and the
   * surroundings receive most of their light from that strip. There the mean over the texel's
   * square is taken. One per thread.
   */
  private static final class UnshadowedLight {
    /** Distance, in texels, below which a lamp is close. */
    private static final double BESIDE = 4;

    private final SobolPointSet places;
    private final double[] at = new double[3];
    private final double[] one = new double[3];

    /**
     * @param places sample points on a texel, over which the mean is taken
     */
    UnshadowedLight(SobolPointSet places) {
      this.places = places;
    }

    /** Writes the irradiance r, g, b, lx. */
    void of(LightSource lamp, TexelSurfacePoint place, double[] out) {
      lamp.unshadowed(place.point, place.normal, out);
      if (!(lamp.away(place.point) < BESIDE * place.size())) {
        return;
      }
      double[] sum = new double[3];
      int count = 0;
      for (int i = 0; i < places.size(); i++) {
        if (place.start(places.x(i), places.y(i), at)) {
          lamp.unshadowed(at, place.normal, one);
          for (int c = 0; c < 3; c++) {
            sum[c] += one[c];
          }
          count++;
        }
      }
      for (int c = 0; c < 3 && count > 0; c++) {
        out[c] = sum[c] / count;
      }
    }
  }
}
