package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Light from the lamps at every texel: what would arrive if nothing were in the way, in closed
 * form, times the share that reaches it. The share is found with many rays on every fourth texel of
 * every fourth row and with one ray on every other texel in between; where all say the same, or the
 * share changes slowly and the single rays agree with that, it is interpolated; elsewhere each
 * texel has rays of its own, few of them in half-shadows, whose noise is evened out with the texels
 * beside that have about the same share.
 */
final class DirectPass {
  private static final int GRID = 4;

  /** Units of a share, and marks for none. */
  private static final int WHOLE = 60_000;

  private static final char UNKNOWN = 65_535;
  private static final char DARK = 65_534;

  /** Single rays that together are as good as those of a texel of the grid. */
  private static final int ENOUGH = 6;

  /** Shares that differ by less count as one. */
  private static final double SAME = 0.02;

  /** A share that changes by more over a cell is not interpolated. */
  private static final double STEEP = 0.12;

  /** Shares of texels side by side that differ by less do so by their noise, not by an edge. */
  private static final double ALIKE = 0.2;

  /** How far the mean of single rays may be from what is interpolated, in standard errors. */
  private static final double AGREES = 2.5;

  private final LightScene scene;
  private final Solution solution;
  private final Texels texels;
  private final LampShadow.Points points;
  private final char[] shares;

  /** What has been found for each texel, before half-shadows are evened out. */
  private final char[] found;

  private final float[] light;
  private final LongAdder rays = new LongAdder();

  DirectPass(LightScene scene, Solution solution, Texels texels, int most, int seed) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    points = LampShadow.Points.of(most, seed);
    shares = new char[texels.count()];
    found = new char[texels.count()];
    light = new float[3 * texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  /** Irradiance by all texels, lx; null if it was cancelled. */
  float @org.jspecify.annotations.Nullable [] gather(WorkProgress progress, DoubleConsumer done) {
    LampTiles tiles = LampTiles.find(scene, solution, texels, points, progress, rays);
    int lamps = scene.lamps().size();
    for (int i = 0; i < lamps; i++) {
      int lamp = i;
      java.util.Arrays.fill(shares, UNKNOWN);
      java.util.Arrays.fill(found, UNKNOWN);
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
      java.util.function.Function<Worker, java.util.function.IntConsumer> task) {
    return ParallelWork.run(
        texels.tiles(),
        64,
        progress,
        done,
        (from, to) -> {
          Worker worker = new Worker(lamp);
          java.util.function.IntConsumer work = task.apply(worker);
          for (int tile = from; tile < to; tile++) {
            if (tiles.has(tile, lamp)) {
              texels.each(tile, work);
            }
          }
          rays.add(worker.shadow.rays());
        });
  }

  /** One thread's work on one lamp. */
  private final class Worker {
    private final int number;
    private final Lamp lamp;
    private final LampShadow shadow = new LampShadow(scene, points);
    private final UnhiddenLight unhidden = new UnhiddenLight(points.onTexel());
    private final TexelPlace place = new TexelPlace(scene, solution, texels);
    private final double[] open = new double[3];
    private int page = -1;
    private int first;
    private TexelMap map = new TexelMap(0, 0, new int[0], new float[0], new float[0], new int[0]);

    // Of the texel looked at: its share by interpolation, and whether its cell has any of the
    // grid.
    private double interpolated;
    private boolean cornered;

    Worker(int number) {
      this.number = number;
      lamp = scene.lamps().get(number);
    }

    private void go(int texel) {
      if (page < 0 || texel < first || texel >= first + map.texels()) {
        page = texels.pageOf(texel);
        first = texels.first(page);
        map = texels.map(page);
      }
    }

    void probe(int texel) {
      go(texel);
      int x = (texel - first) % map.width();
      int y = (texel - first) / map.width();
      boolean onGrid = onGrid(x, y);
      if (!onGrid && (x + y) % 2 != 0 && besideGrid(x, y)) {
        return;
      }
      place.at(texel);
      double share;
      if (onGrid) {
        share = shadow.share(place, number, texel + 7919 * number);
      } else {
        int cell = first + y / GRID * GRID * map.width() + x / GRID * GRID;
        share =
            shadow.one(place, number, y % GRID * GRID + x % GRID, cell + 7919 * number + 0x1234567);
      }
      shares[texel] =
          share == LampShadow.NOTHING ? DARK : (char) Math.round(WHOLE * Math.min(1, share));
    }

    /** Finds the share and adds its light, unless that is to be evened out first. */
    void find(int texel) {
      go(texel);
      int x = (texel - first) % map.width();
      int y = (texel - first) / map.width();
      place.at(texel);
      unhidden.of(lamp, place, open);
      if (!(open[0] + open[1] + open[2] > 0)) {
        return;
      }
      double share;
      if (onGrid(x, y) && settled(x, y, texel)) {
        share = (double) shares[texel] / WHOLE;
      } else if (onGrid(x, y)) {
        share = Math.max(0, shadow.edge(place, number, texel + 7919 * number));
      } else if (interpolate(x, y)) {
        share = interpolated;
      } else if (cornered || lamp.hard()) {
        share = Math.max(0, shadow.edge(place, number, texel + 7919 * number));
      } else {
        share = Math.max(0, shadow.small(place, number, texel + 7919 * number));
      }
      found[texel] = (char) Math.round(WHOLE * Math.min(1, share));
      if (lamp.hard() || !mixed(found[texel])) {
        add(texel, share);
      }
    }

    private void add(int texel, double share) {
      for (int c = 0; c < 3; c++) {
        light[3 * texel + c] += (float) (share * open[c]);
      }
    }

    private static boolean mixed(char share) {
      return share >= SAME * WHOLE && share <= (1 - SAME) * WHOLE;
    }

    /** In a half-shadow, takes the mean over the texels around that have about the same share. */
    void even(int texel) {
      char own = found[texel];
      if (own >= DARK || !mixed(own)) {
        return;
      }
      go(texel);
      int x = (texel - first) % map.width();
      int y = (texel - first) / map.width();
      int chart = map.chart()[texel - first];
      double sum = 0;
      int count = 0;
      for (int ny = y - 1; ny <= y + 1; ny++) {
        for (int nx = x - 1; nx <= x + 1; nx++) {
          char share = in(nx, ny, chart) ? found[first + ny * map.width() + nx] : UNKNOWN;
          if (share < DARK && Math.abs(share - own) <= ALIKE * WHOLE) {
            sum += share;
            count++;
          }
        }
      }
      place.at(texel);
      unhidden.of(lamp, place, open);
      add(texel, sum / count / WHOLE);
    }

    /** Whether a texel is one of the grid, with others of it in its chart. */
    private boolean onGrid(int x, int y) {
      int chart = map.chart()[y * map.width() + x];
      return x % GRID == 0
          && y % GRID == 0
          && (in(x - GRID, y, chart)
              || in(x + GRID, y, chart)
              || in(x, y - GRID, chart)
              || in(x, y + GRID, chart));
    }

    /** Whether a texel's cell has one of the grid, so that every other single ray will do. */
    private boolean besideGrid(int x, int y) {
      int x0 = x / GRID * GRID;
      int y0 = y / GRID * GRID;
      return in(x0, y0, map.chart()[y * map.width() + x]) && onGrid(x0, y0);
    }

    /** Whether the rays of a texel of the grid are enough: no edge is near, or it had them all. */
    private boolean settled(int x, int y, int texel) {
      char share = shares[texel];
      boolean hidden = share < SAME * WHOLE;
      boolean mixed = !hidden && share < (1 - SAME) * WHOLE;
      return share < DARK && (mixed || allSay(x, y, map.chart()[y * map.width() + x], hidden));
    }

    /** Whether the texels around say what reaches this one. */
    private boolean interpolate(int x, int y) {
      int x0 = x / GRID * GRID;
      int y0 = y / GRID * GRID;
      int chart = map.chart()[y * map.width() + x];
      double low = 2;
      double high = -1;
      double sum = 0;
      double weights = 0;
      for (int k = 0; k < 4; k++) {
        int cx = x0 + (k & 1) * GRID;
        int cy = y0 + (k >> 1) * GRID;
        char share = at(cx, cy, chart);
        if (share >= DARK) {
          continue;
        }
        double value = (double) share / WHOLE;
        double wx = 1 - Math.abs(x - cx) / (double) GRID;
        double wy = 1 - Math.abs(y - cy) / (double) GRID;
        low = Math.min(low, value);
        high = Math.max(high, value);
        sum += wx * wy * value;
        weights += wx * wy;
      }
      boolean whole = weights > 0.999;
      cornered = weights > 0;
      if (!(weights > 0)) {
        return say(x, y, chart);
      }
      if (high - low > STEEP) {
        return false;
      }
      interpolated = sum / weights;
      boolean even = high < SAME || low > 1 - SAME;
      return even ? allSay(x, y, chart, high < SAME) : whole && agree(x0, y0, chart);
    }

    /** Whether single rays around a texel all find the lamp hidden, or all see it. */
    private boolean allSay(int x, int y, int chart, boolean hidden) {
      for (int ny = y - 2; ny <= y + 2; ny++) {
        for (int nx = x - 2; nx <= x + 2; nx++) {
          char share = at(nx, ny, chart);
          if (share < DARK && (hidden ? share > SAME * WHOLE : share < (1 - SAME) * WHOLE)) {
            return false;
          }
        }
      }
      return true;
    }

    /** Whether single rays of a cell are what a share in a half-shadow gives. */
    private boolean agree(int x0, int y0, int chart) {
      double sum = 0;
      int count = 0;
      for (int y = y0; y < y0 + GRID; y++) {
        for (int x = x0; x < x0 + GRID; x++) {
          char share = at(x, y, chart);
          if (share < DARK && (x > x0 || y > y0)) {
            sum += (double) share / WHOLE;
            count++;
          }
        }
      }
      double error = Math.sqrt(interpolated * (1 - interpolated) / Math.max(1, count));
      return count >= ENOUGH && Math.abs(sum / count - interpolated) < AGREES * error + SAME;
    }

    /** Likewise without any texel of the grid: the single rays must be all that is needed. */
    private boolean say(int x, int y, int chart) {
      int count = 0;
      int seen = 0;
      for (int ny = y - 2; ny <= y + 2; ny++) {
        for (int nx = x - 2; nx <= x + 2; nx++) {
          char share = at(nx, ny, chart);
          count += share < DARK ? 1 : 0;
          seen += share < DARK && share > (1 - SAME) * WHOLE ? 1 : 0;
        }
      }
      interpolated = seen == 0 ? 0 : 1;
      return count >= ENOUGH && (seen == count || seen == 0 && allSay(x, y, chart, true));
    }

    private char at(int x, int y, int chart) {
      return in(x, y, chart) ? shares[first + y * map.width() + x] : UNKNOWN;
    }

    private boolean in(int x, int y, int chart) {
      return x >= 0
          && y >= 0
          && x < map.width()
          && y < map.height()
          && map.chart()[y * map.width() + x] == chart;
    }
  }
}
