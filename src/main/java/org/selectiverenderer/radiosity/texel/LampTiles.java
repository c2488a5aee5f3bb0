package org.selectiverenderer.radiosity.texel;

import java.util.List;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Light culling by tiles of texels: the lamps that may shine on a tile are those visible from its
 * patches, those that one more shadow ray reaches, and those of the adjacent tiles. Lamps from the
 * 64th on are assumed to shine everywhere.
 */
final class LampTiles {
  /**
   * Least share that a lamp would add to the light of the patch for a further shadow ray to be cast
   * to it.
   */
  private static final double MATTERS = 0.002;

  private final Texels texels;
  private final long[] lamps;

  private LampTiles(Texels texels, long[] lamps) {
    this.texels = texels;
    this.lamps = lamps;
  }

  boolean has(int tile, int lamp) {
    return lamp >= Long.SIZE || (lamps[tile] >>> lamp & 1) != 0;
  }

  static LampTiles find(
      LightScene scene,
      Solution solution,
      Texels texels,
      LampShadow.Points points,
      WorkProgress progress,
      java.util.concurrent.atomic.LongAdder rays) {
    long[] own = new long[texels.tiles()];
    ParallelWork.run(
        own.length,
        64,
        progress,
        share -> {},
        (from, to) -> {
          TexelPlace place = new TexelPlace(scene, solution, texels);
          LampShadow shadow = new LampShadow(scene, points);
          Tries tries = new Tries(scene.lamps(), solution, place, shadow);
          for (int tile = from; tile < to; tile++) {
            own[tile] = tries.of(texels, tile);
          }
          rays.add(shadow.rays());
        });
    return new LampTiles(texels, own).spread();
  }

  /** Finds the lamps of tiles. One per thread. */
  private static final class Tries {
    private final List<Lamp> lamps;
    private final Solution solution;
    private final TexelPlace place;
    private final LampShadow shadow;
    private final double[] light = new double[3];
    private long known;
    private int last;

    Tries(List<Lamp> lamps, Solution solution, TexelPlace place, LampShadow shadow) {
      this.lamps = lamps;
      this.solution = solution;
      this.place = place;
      this.shadow = shadow;
    }

    long of(Texels texels, int tile) {
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

  private LampTiles spread() {
    long[] wide = new long[lamps.length];
    for (int page = 0; page < texels.atlas().pages().size(); page++) {
      TexelMap map = texels.map(page);
      int across = Texels.across(map);
      int first = texels.firstTile(page);
      int rows = (map.height() + Texels.TILE - 1) / Texels.TILE;
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
    return new LampTiles(texels, wide);
  }
}
