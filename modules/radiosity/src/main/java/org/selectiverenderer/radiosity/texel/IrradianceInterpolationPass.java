package org.selectiverenderer.radiosity.texel;

import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/** Computes the indirect irradiance of every texel by interpolation between irradiance records. */
final class IrradianceInterpolationPass {
  private static final int CHUNK = 16;

  private final RadiosityScene scene;
  private final RadiositySolution solution;
  private final TexelIndex texels;
  private final IrradianceCachePass pass;
  private final NoiseHistogram noise = new NoiseHistogram();

  IrradianceInterpolationPass(
      RadiosityScene scene,
      RadiositySolution solution,
      TexelIndex texels,
      IrradianceCachePass pass) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.pass = pass;
  }

  /**
   * Adds the indirect irradiance r, g, b to all texels that are gathered; returns the statistics of
   * the noise that is left in them.
   */
  TexelNoiseStatistics addTo(float[] light) {
    IntStream.range(0, (texels.tiles() + CHUNK - 1) / CHUNK)
        .parallel()
        .forEach(
            chunk -> {
              Runs runs = new Runs(light);
              int end = Math.min(texels.tiles(), (chunk + 1) * CHUNK);
              for (int tile = chunk * CHUNK; tile < end; tile++) {
                texels.each(tile, runs::next);
                runs.end();
              }
            });
    return noise.of(pass.records().size());
  }

  /**
   * Collects runs of adjacent texels in one chart, which share the search for records. One per
   * thread.
   */
  private final class Runs {
    private final float[] light;
    private final TexelSurfacePoint place = new TexelSurfacePoint(scene, solution, texels);
    private final IrradianceInterpolator reader = new IrradianceInterpolator(pass.records());
    private final int[] run = new int[TexelIndex.TILE];
    private int size;
    private int chart;

    Runs(float[] light) {
      this.light = light;
    }

    void next(int texel) {
      place.at(texel);
      boolean goesOn =
          size > 0 && size < run.length && run[size - 1] == texel - 1 && place.chart() == chart;
      if (!goesOn) {
        end();
      }
      chart = place.chart();
      run[size++] = texel;
    }

    private double sum(int texel) {
      return (double) light[3 * texel] + light[3 * texel + 1] + light[3 * texel + 2];
    }

    void end() {
      reader.begin();
      for (int i = 0; i < size; i++) {
        place.at(run[i]);
        reader.include(place.point);
      }
      if (size > 0) {
        reader.find();
      }
      for (int i = 0; i < size; i++) {
        place.at(run[i]);
        boolean known = pass.at(reader, run[i], place);
        for (int c = 0; c < 3; c++) {
          light[3 * run[i] + c] +=
              known ? (float) reader.light[c] : solution.indirect()[3 * place.patch + c];
        }
        double there = sum(run[i]);
        if (known && there > 0) {
          noise.add(reader.error / Math.max(pass.dark(), there));
        }
      }
      size = 0;
    }
  }

  /**
   * A histogram of the texels' noise, filled by several threads; integer counts give the same sums
   * in any order.
   */
  private static final class NoiseHistogram {
    /** Width of a bin, as a share of the light. The last of the bins takes all larger values. */
    private static final double STEP = 1e-4;

    private final AtomicIntegerArray texels = new AtomicIntegerArray(2_000);

    /**
     * @param share the standard error of a texel, as a share of its light
     */
    void add(double share) {
      texels.incrementAndGet((int) Math.max(0, Math.min(texels.length() - 1, share / STEP)));
    }

    /**
     * @param places number of irradiance records
     */
    TexelNoiseStatistics of(int places) {
      long all = 0;
      double sum = 0;
      for (int i = 0; i < texels.length(); i++) {
        all += texels.get(i);
        sum += texels.get(i) * (i + 0.5) * STEP;
      }
      if (all == 0) {
        return TexelNoiseStatistics.NONE;
      }
      long below = 0;
      int most = 0;
      while (below + texels.get(most) < 0.95 * all) {
        below += texels.get(most++);
      }
      return new TexelNoiseStatistics(sum / all, (most + 1) * STEP, places);
    }
  }
}
