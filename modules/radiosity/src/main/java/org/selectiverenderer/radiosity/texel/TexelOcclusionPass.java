package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Probes the surroundings of each texel before indirect light is gathered. Texels that nobody can
 * see are left out: those inside of solids, those covered by another surface and those in closed
 * cavities, such as the foot of a bin. Rays are needed for that only where no lamp shines or other
 * surfaces are near. One short ray from each texel tells where surfaces are near, so that
 * interpolation does not skip their contact shadows.
 */
final class TexelOcclusionPass {
  /** Number of rays that test whether a point is visible. */
  private static final int RAYS = 4;

  /** Length of the short rays: distance up to which surfaces are near, texels. */
  private static final double NEAR = 6;

  /** Number of steps per texel in which the distance is stored. */
  private static final int STEPS = 16;

  /**
   * Number of texels to each side whose short rays count, and the least number of hits among them.
   */
  private static final int AROUND = 2;

  private static final int ENOUGH = 2;

  /** Side of the square of texels whose short rays have different directions. */
  private static final int CELL = 4;

  /** Largest distance of valid records where surfaces are near, texels. */
  private static final double REACH = 3;

  /**
   * In corners light changes from one texel to the next. A texel lies in a corner if the short ray
   * of an adjacent texel ends within {@link #CORNER} texels; there, records are valid within {@link
   * #CORNER_REACH} texels.
   */
  private static final double CORNER = 2;

  private static final int RIGHT_AROUND = 1;
  private static final double CORNER_REACH = 1.4;

  private final TexelIndex texels;

  /**
   * Per texel: the length of its short ray in 16ths of a texel, plus one; 0 if the ray hit nothing.
   */
  private final byte[] meets;

  private final LongAdder rays = new LongAdder();

  private TexelOcclusionPass(TexelIndex texels) {
    this.texels = texels;
    meets = new byte[texels.count()];
  }

  long rays() {
    return rays.sum();
  }

  /** Probes all texels. */
  static TexelOcclusionPass look(
      RadiosityScene scene,
      RadiositySolution solution,
      TexelIndex texels,
      float[] direct,
      TexelRayCaster.Sets sets,
      RadiosityProgress progress) {
    TexelOcclusionPass pass = new TexelOcclusionPass(texels);
    HitRadiance hits = new HitRadiance(scene, solution, texels, direct);
    ParallelFor.run(
        texels.tiles(),
        64,
        progress,
        share -> {},
        (from, to) -> {
          TexelOcclusionProbe around = new TexelOcclusionProbe(scene, hits, sets);
          TexelSurfacePoint place = new TexelSurfacePoint(scene, solution, texels);
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

  private void look(int texel, TexelSurfacePoint place, TexelOcclusionProbe around) {
    int page = texels.pageOf(texel);
    int width = texels.map(page).width();
    int x = (texel - texels.first(page)) % width;
    int y = (texel - texels.first(page)) / width;
    int i = 7 * (y % CELL * CELL + x % CELL) % (CELL * CELL);
    double far = around.near(place, i % around.most(), y / CELL * width + x / CELL, NEAR);
    meets[texel] = far > NEAR ? 0 : (byte) (1 + STEPS * far);
  }

  /** Returns the largest distance of records that are valid for a texel, metres. */
  double reach(int texel, TexelSurfacePoint place) {
    int page = texels.pageOf(texel);
    AtlasPage map = texels.map(page);
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

  /**
   * Counts the texels around a texel, in its chart, whose short rays ended within a distance in
   * texels.
   */
  private int found(AtlasPage map, int first, int x, int y, int around, double most) {
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
