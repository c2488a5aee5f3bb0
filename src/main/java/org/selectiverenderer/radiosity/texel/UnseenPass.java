package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;
import org.selectiverenderer.radiosity.work.ParallelWork;
import org.selectiverenderer.radiosity.work.WorkProgress;

/**
 * Leaves out texels inside of solids and those that are covered closely: nobody sees them. Only
 * where no lamp shines are rays needed to know.
 */
final class UnseenPass {
  private static final int RAYS = 4;

  private UnseenPass() {}

  /** Returns the rays cast. */
  static long leaveOut(
      LightScene scene,
      Solution solution,
      Texels texels,
      float[] direct,
      Hemisphere.Sets sets,
      WorkProgress progress) {
    LongAdder rays = new LongAdder();
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
                  if (direct[3 * texel] + direct[3 * texel + 1] + direct[3 * texel + 2] > 0) {
                    return;
                  }
                  place.at(texel);
                  if (hemisphere.unseen(place, RAYS, texel)) {
                    texels.leave(texel);
                  }
                });
          }
          rays.add(hemisphere.rays());
        });
    return rays.sum();
  }
}
