package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Computes the direct irradiance from the lamps at every texel: the unshadowed irradiance in closed
 * form, times the visible share of the lamp. That share is estimated with many shadow rays at every
 * fourth texel of every fourth row, and with one ray at every other texel in between. Where all of
 * them agree, or the share changes slowly and the single rays agree with the interpolated share, it
 * is interpolated. Elsewhere each texel casts rays of its own, few of them in penumbras, and their
 * noise is filtered with the adjacent texels that have about the same share.
 */
final class DirectPass {
  private final LightScene scene;
  private final Solution solution;
  private final Texels texels;
  private final LampShadow.Points points;
  private final char[] shares;

  /** Per texel: its visible share, before penumbras are filtered. */
  private final char[] found;

  /** Per texel: whether its share is filtered, since it comes of few rays or lies in a penumbra. */
  private final boolean[] noisy;

  private final float[] light;
  private final LongAdder rays = new LongAdder();

  DirectPass(LightScene scene, Solution solution, Texels texels, int most, int seed) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    points = LampShadow.Points.of(most, seed);
    shares = new char[texels.count()];
    found = new char[texels.count()];
    noisy = new boolean[texels.count()];
    light = new float[3 * texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  /** Returns the irradiance r, g, b of all texels, lx; null if the work was cancelled. */
  float @Nullable [] gather(WorkProgress progress, DoubleConsumer done) {
    LampTiles tiles = LampTiles.find(scene, solution, texels, points, progress, rays);
    int lamps = scene.lamps().size();
    for (int i = 0; i < lamps; i++) {
      int lamp = i;
      Arrays.fill(shares, ShareGrid.UNKNOWN);
      Arrays.fill(found, ShareGrid.UNKNOWN);
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
      LampTiles tiles,
      int lamp,
      WorkProgress progress,
      DoubleConsumer done,
      Function<Worker, IntConsumer> task) {
    return ParallelWork.run(
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
    private final Lamp lamp;
    private final LampShadow shadow = new LampShadow(scene, points);
    private final UnhiddenLight unhidden = new UnhiddenLight(points.onTexel());
    private final TexelPlace place = new TexelPlace(scene, solution, texels);
    private final double[] open = new double[3];
    private final ShareGrid grid = new ShareGrid(texels, shares);
    private final ShareGrid around = new ShareGrid(texels, found);

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
      shares[texel] = ShareGrid.of(share);
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
      found[texel] = ShareGrid.of(share);
      noisy[texel] = !lamp.hard() && (own || ShareGrid.mixed(found[texel]));
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
}
