package org.selectiverenderer.radiosity.reference;

import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Pictures of what is known of every place, with no paths: the lit result, and what glows. */
final class LightingResultRenderer {
  private LightingResultRenderer() {}

  /** Adds what a place has; called by several threads. */
  @FunctionalInterface
  private interface Part {
    void add(SurfacePoint at, int place, double[] sum);
  }

  /** Reflected radiance r, g, b per pixel, cd/m2, the background black. */
  static double[] reflected(RadiosityScene scene, PrimaryHits hits, Irradiance light) {
    return sum(
        scene,
        hits,
        (at, place, sum) -> {
          double[] irradiance = new double[3];
          light.at(hits.triangle()[place], hits.u()[place], hits.v()[place], irradiance);
          for (int c = 0; c < 3; c++) {
            sum[c] += at.albedo[c] * irradiance[c] / Math.PI;
          }
        });
  }

  /** Radiance of what glows, r, g, b per pixel, cd/m2. */
  static double[] glowing(RadiosityScene scene, PrimaryHits hits) {
    return sum(
        scene,
        hits,
        (at, place, sum) -> {
          for (int c = 0; c < 3; c++) {
            sum[c] += at.glow[c];
          }
        });
  }

  private static double[] sum(RadiosityScene scene, PrimaryHits hits, Part part) {
    double[] all = new double[3 * hits.pixels()];
    IntStream.range(0, hits.height())
        .parallel()
        .forEach(
            row -> {
              SurfacePoint at = new SurfacePoint(scene);
              double[] own = new double[3];
              for (int pixel = row * hits.width(); pixel < (row + 1) * hits.width(); pixel++) {
                own[0] = 0;
                own[1] = 0;
                own[2] = 0;
                for (int i = pixel * hits.places(); i < (pixel + 1) * hits.places(); i++) {
                  if (hits.triangle()[i] != Ray.NOTHING) {
                    at.at(hits.triangle()[i], hits.u()[i], hits.v()[i], hits.behind()[i]);
                    part.add(at, i, own);
                  }
                }
                for (int c = 0; c < 3; c++) {
                  all[3 * pixel + c] = own[c] / hits.places();
                }
              }
            });
    return all;
  }
}
