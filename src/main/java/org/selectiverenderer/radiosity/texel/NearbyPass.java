package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Looks around each texel before light from surfaces is gathered. Texels inside of solids and those
 * on which something lies are left out: nobody sees them. Only where no lamp shines are rays needed
 * to know that. One short ray from each texel tells where things are near, so that their contact
 * shadows are not passed over.
 */
final class NearbyPass {
  /** Rays to know whether a place is seen. */
  private static final int RAYS = 4;

  /** How far things are near, texels. */
  private static final double NEAR = 6;

  /** Texels around whose rays count, to each side, and how many of them have to meet something. */
  private static final int AROUND = 2;

  private static final int ENOUGH = 2;

  /** Sides of squares of texels whose short rays go to different directions. */
  private static final int CELL = 4;

  /** Near to things, records count up to so many texels away. */
  private static final double REACH = 3;

  private final Texels texels;
  private final boolean[] meets;
  private final LongAdder rays = new LongAdder();

  private NearbyPass(Texels texels) {
    this.texels = texels;
    meets = new boolean[texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  static NearbyPass look(
      LightScene scene,
      Solution solution,
      Texels texels,
      float[] direct,
      Hemisphere.Sets sets,
      WorkProgress progress) {
    NearbyPass pass = new NearbyPass(texels);
    HitLight hits = new HitLight(scene, solution, texels, direct);
    ParallelWork.run(
        texels.tiles(),
        64,
        progress,
        share -> {},
        (from, to) -> {
          Hemisphere hemisphere = new Hemisphere(scene, hits, sets);
          TexelPlace place = new TexelPlace(scene, solution, texels);
          for (int tile = from; tile < to; tile++) {
            texels.each(
                tile,
                texel -> {
                  place.at(texel);
                  pass.look(texel, place, hemisphere);
                  boolean dark =
                      direct[3 * texel] + direct[3 * texel + 1] + direct[3 * texel + 2] == 0;
                  if (dark && hemisphere.unseen(place, RAYS, texel)) {
                    texels.leave(texel);
                  }
                });
          }
          pass.rays.add(hemisphere.rays());
        });
    return pass;
  }

  private void look(int texel, TexelPlace place, Hemisphere hemisphere) {
    int page = texels.pageOf(texel);
    int width = texels.map(page).width();
    int x = (texel - texels.first(page)) % width;
    int y = (texel - texels.first(page)) / width;
    int i = 7 * (y % CELL * CELL + x % CELL) % (CELL * CELL);
    meets[texel] = hemisphere.near(place, i % hemisphere.most(), y / CELL * width + x / CELL, NEAR);
  }

  /** How far away records may be for a texel, metres. */
  double reach(int texel, TexelPlace place) {
    int page = texels.pageOf(texel);
    TexelMap map = texels.map(page);
    int first = texels.first(page);
    int x = (texel - first) % map.width();
    int y = (texel - first) / map.width();
    int chart = map.chart()[texel - first];
    int found = 0;
    for (int ny = Math.max(0, y - AROUND); ny <= Math.min(map.height() - 1, y + AROUND); ny++) {
      for (int nx = Math.max(0, x - AROUND); nx <= Math.min(map.width() - 1, x + AROUND); nx++) {
        int there = ny * map.width() + nx;
        found += meets[first + there] && map.chart()[there] == chart ? 1 : 0;
      }
    }
    return found >= ENOUGH ? REACH * place.size() : Double.POSITIVE_INFINITY;
  }
}
