package org.selectiverenderer.radiosity.texel;

import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.solve.Solution;

/** Computes the indirect irradiance of every texel by interpolation between irradiance records. */
final class IndirectBetween {
  private static final int CHUNK = 16;

  private final LightScene scene;
  private final Solution solution;
  private final Texels texels;
  private final IndirectPass pass;
  private final NoiseCount noise = new NoiseCount();

  IndirectBetween(LightScene scene, Solution solution, Texels texels, IndirectPass pass) {
    this.scene = scene;
    this.solution = solution;
    this.texels = texels;
    this.pass = pass;
  }

  /**
   * Adds the indirect irradiance r, g, b to all texels that are gathered; returns the statistics of
   * the noise that is left in them.
   */
  TexelNoise addTo(float[] light) {
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
    private final TexelPlace place = new TexelPlace(scene, solution, texels);
    private final RecordReader reader = new RecordReader(pass.records());
    private final int[] run = new int[Texels.TILE];
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
}
