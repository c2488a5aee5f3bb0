package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Looks around each texel before light from surfaces is gathered. Texels inside of solids, those on
 * which something lies and those in closed hollows, such as the foot of a bin, are left out: nobody
 * sees them. Only where no lamp shines, or where things are near, are rays needed to know that. One
 * short ray from each texel tells where things are near, so that their contact shadows are not
 * passed over.
 */
final class NearbyPass {
  /** Rays to know whether a place is seen. */
  private static final int RAYS = 4;

  /** How far things are near, texels. */
  private static final double NEAR = 6;

  /** Parts of a texel in which that is told. */
  private static final int STEPS = 16;

  /** Texels around whose rays count, to each side, and how many of them have to meet something. */
  private static final int AROUND = 2;

  private static final int ENOUGH = 2;

  /** Sides of squares of texels whose short rays go to different directions. */
  private static final int CELL = 4;

  /** Near to things, records count up to so many texels away. */
  private static final double REACH = 3;

  /**
   * In corners light changes from one texel to the next: of the texels right around the ray of one
   * ends within so many texels, and there records count up to so many texels away.
   */
  private static final double CORNER = 2;

  private static final int RIGHT_AROUND = 1;
  private static final double CORNER_REACH = 1.4;

  private final Texels texels;

  /**
   * How far a short ray went from each texel, in steps of a 16th of a texel; 0 if it met nothing.
   */
  private final byte[] meets;

  private final LongAdder rays = new LongAdder();

  private NearbyPass(Texels texels) {
    this.texels = texels;
    meets = new byte[texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  /** Looks around all texels. */
  static NearbyPass look(
      LightScene scene,
      Solution solution,
      Texels texels,
      float[] direct,
      TexelRays.Sets sets,
      WorkProgress progress) {
    NearbyPass pass = new NearbyPass(texels);
    HitLight hits = new HitLight(scene, solution, texels, direct);
    ParallelWork.run(
        texels.tiles(),
        64,
        progress,
        share -> {},
        (from, to) -> {
          PlaceNeighbourhood around = new PlaceNeighbourhood(scene, hits, sets);
          TexelPlace place = new TexelPlace(scene, solution, texels);
          for (int tile = from; tile < to; tile++) {
            texels.each(
                tile,
                texel -> {
                  place.at(texel);
                  pass.look(texel, place, around);
                  boolean noLamp =
                      direct[3 * texel] + direct[3 * texel + 1] + direct[3 * texel + 2] == 0;
                  if (around.overlaid(place)
                      || noLamp && around.unseen(place, RAYS, texel)
                      || pass.meets[texel] > 0 && around.hollow(place, texel)) {
                    texels.leave(texel);
                  }
                });
          }
          pass.rays.add(around.rays());
        });
    return pass;
  }

  private void look(int texel, TexelPlace place, PlaceNeighbourhood around) {
    int page = texels.pageOf(texel);
    int width = texels.map(page).width();
    int x = (texel - texels.first(page)) % width;
    int y = (texel - texels.first(page)) / width;
    int i = 7 * (y % CELL * CELL + x % CELL) % (CELL * CELL);
    double far = around.near(place, i % around.most(), y / CELL * width + x / CELL, NEAR);
    meets[texel] = far > NEAR ? 0 : (byte) (1 + STEPS * far);
  }

  /** How far away records may be for a texel, metres. */
  double reach(int texel, TexelPlace place) {
    int page = texels.pageOf(texel);
    TexelMap map = texels.map(page);
    int first = texels.first(page);
    int x = (texel - first) % map.width();
    int y = (texel - first) / map.width();
    if (found(map, first, x, y, RIGHT_AROUND, CORNER) > 0) {
      return CORNER_REACH * place.size();
    }
    return found(map, first, x, y, AROUND, NEAR) >= ENOUGH
        ? REACH * place.size()
        : Double.POSITIVE_INFINITY;
  }

  /** How many texels of one chart around a texel have met something within some texels. */
  private int found(TexelMap map, int first, int x, int y, int around, double most) {
    int chart = map.chart()[y * map.width() + x];
    int found = 0;
    for (int ny = Math.max(0, y - around); ny <= Math.min(map.height() - 1, y + around); ny++) {
      for (int nx = Math.max(0, x - around); nx <= Math.min(map.width() - 1, x + around); nx++) {
        int there = ny * map.width() + nx;
        byte met = meets[first + there];
        found += met > 0 && met <= 1 + STEPS * most && map.chart()[there] == chart ? 1 : 0;
      }
    }
    return found;
  }
}
