package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Light culling by tiles of texels: the lamps that may shine on a tile are those visible from its
 * patches, those that one more shadow ray reaches, and those of the adjacent tiles. Lamps from the
 * 64th on are assumed to shine everywhere.
 */
final class TileLightCulling {
  /**
   * Least share that a lamp would add to the light of the patch for a further shadow ray to be cast
   * to it.
   */
  private static final double MATTERS = 0.002;

  private final TexelIndex texels;
  private final long[] lamps;

  private TileLightCulling(TexelIndex texels, long[] lamps) {
    this.texels = texels;
    this.lamps = lamps;
  }

  boolean has(int tile, int lamp) {
    return lamp >= Long.SIZE || (lamps[tile] >>> lamp & 1) != 0;
  }

  static TileLightCulling find(
      RadiosityScene scene,
      RadiositySolution solution,
      TexelIndex texels,
      LightVisibilityEstimator.Points points,
      RadiosityProgress progress,
      java.util.concurrent.atomic.LongAdder rays) {
    long[] own = new long[texels.tiles()];
    ParallelFor.run(
        own.length,
        64,
        progress,
        share -> {},
        (from, to) -> {
          TexelSurfacePoint place = new TexelSurfacePoint(scene, solution, texels);
          LightVisibilityEstimator shadow = new LightVisibilityEstimator(scene, points);
          Tries tries = new Tries(scene.lamps(), solution, place, shadow);
          for (int tile = from; tile < to; tile++) {
            own[tile] = tries.of(texels, tile);
          }
          rays.add(shadow.rays());
        });
    return new TileLightCulling(texels, own).spread();
  }

  /** Finds the lamps of tiles. One per thread. */
  private static final class Tries {
    private final List<LightSource> lamps;
    private final RadiositySolution solution;
    private final TexelSurfacePoint place;
    private final LightVisibilityEstimator shadow;
    private final double[] light = new double[3];
    private long known;
    private int last;

    Tries(
        List<LightSource> lamps,
        RadiositySolution solution,
        TexelSurfacePoint place,
        LightVisibilityEstimator shadow) {
      this.lamps = lamps;
      this.solution = solution;
      this.place = place;
      this.shadow = shadow;
    }

    long of(TexelIndex texels, int tile) {
      known = 0;
      last = -1;
      texels.each(
          tile,
          texel -> {
            place.at(texel);
            known |= solution.lampsOf()[place.patch];
            last = texel;
          });
      if (last < 0) {
        return 0;
      }
      place.at(last);
      double there = 0;
      for (int i = 3 * place.patch; i < 3 * place.patch + 3; i++) {
        there += solution.direct()[i] + solution.indirect()[i];
      }
      for (int lamp = 0; lamp < Math.min(Long.SIZE, lamps.size()); lamp++) {
        if ((known >>> lamp & 1) == 0) {
          lamps.get(lamp).unshadowed(place.point, place.normal, light);
          boolean matters = light[0] + light[1] + light[2] > MATTERS * there;
          if (matters && shadow.one(place, lamp, 0, 31 * tile + lamp) > 0) {
            known |= 1L << lamp;
          }
        }
      }
      return known;
    }
  }

  private TileLightCulling spread() {
    long[] wide = new long[lamps.length];
    for (int page = 0; page < texels.atlas().pages().size(); page++) {
      AtlasPage map = texels.map(page);
      int across = TexelIndex.across(map);
      int first = texels.firstTile(page);
      int rows = (map.height() + TexelIndex.TILE - 1) / TexelIndex.TILE;
      for (int i = 0; i < across * rows; i++) {
        int x = i % across;
        int y = i / across;
        for (int ny = Math.max(0, y - 1); ny <= Math.min(rows - 1, y + 1); ny++) {
          for (int nx = Math.max(0, x - 1); nx <= Math.min(across - 1, x + 1); nx++) {
            wide[first + i] |= lamps[first + ny * across + nx];
          }
        }
      }
    }
    return new TileLightCulling(texels, wide);
  }
}
