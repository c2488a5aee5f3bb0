package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.LongAdder;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.radiosity.parallel.ParallelFor;
import org.selectiverenderer.radiosity.parallel.RadiosityProgress;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/** Gathers irradiance records at texels in parallel, and counts the rays. */
final class RecordGatherer {
  /** Gathers one record. */
  interface Step {
    /**
     * Gathers the record of a texel.
     *
     * @param index the texel's index among those of the call
     * @param place the texel's surface point
     * @param record receives the record; reused for the next one
     */
    void gather(
        int index,
        TexelSurfacePoint place,
        HemisphereIrradianceEstimator hemisphere,
        IrradianceRecord record);
  }

  private static final int CHUNK = 64;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final float[] direct;
  private final TexelRayCaster.Sets sets;
  private final LongAdder rays = new LongAdder();

  /**
   * @param direct the direct light of each texel; r, g, b, lx
   */
  RecordGatherer(
      RadiosityScene scene,
      RadiositySolution solution,
      TexelIndex texels,
      float[] direct,
      TexelRayCaster.Sets sets) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.direct = direct;
    this.sets = sets;
  }

  /** Returns the number of rays cast so far. */
  long rays() {
    return rays.sum();
  }

  /** Returns a surface point that can be moved from texel to texel. */
  TexelSurfacePoint place() {
    return new TexelSurfacePoint(scene, solution, texels);
  }

  /** Gathers the records of texels; returns false if the work was cancelled. */
  boolean gather(int[] at, RadiosityProgress progress, DoubleConsumer done, Step step) {
    HitRadiance hits = new HitRadiance(scene, solution, texels, direct);
    return ParallelFor.run(
        at.length,
        CHUNK,
        progress,
        done,
        (from, to) -> {
          HemisphereIrradianceEstimator hemisphere =
              new HemisphereIrradianceEstimator(scene, hits, sets);
          TexelSurfacePoint place = place();
          IrradianceRecord record = new IrradianceRecord();
          for (int i = from; i < to; i++) {
            place.at(at[i]);
            step.gather(i, place, hemisphere, record);
          }
          rays.add(hemisphere.rays());
        });
  }
}
