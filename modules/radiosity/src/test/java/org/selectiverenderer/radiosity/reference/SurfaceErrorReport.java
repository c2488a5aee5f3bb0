package org.selectiverenderer.radiosity.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Which surfaces the errors of a picture lie on: the worst first. */
final class SurfaceErrorReport {
  private static final int SHOWN = 24;

  private SurfaceErrorReport() {}

  private static final class Tally {
    int pixels;
    double ours;
    double reference;
    double off;
  }

  /** One line for each of the bodies with the largest shares of the error. */
  static String text(RadiosityScene scene, PrimaryHits hits, double[] ours, double[] reference) {
    List<Integer> bodies = new ArrayList<>();
    Tally[] tallies = new Tally[scene.bodies().size()];
    double all = 0;
    for (int pixel = 0; pixel < hits.pixels(); pixel++) {
      int body = body(scene, hits, pixel);
      if (body < 0) {
        continue;
      }
      if (tallies[body] == null) {
        tallies[body] = new Tally();
        bodies.add(body);
      }
      Tally tally = tallies[body];
      double is = ImageErrorMetrics.luminance(ours, pixel);
      double wanted = ImageErrorMetrics.luminance(reference, pixel);
      tally.pixels++;
      tally.ours += is;
      tally.reference += wanted;
      tally.off += Math.abs(is - wanted);
      all += Math.abs(is - wanted);
    }
    bodies.sort(Comparator.comparingDouble((Integer body) -> -tallies[body].off));
    StringBuilder out = new StringBuilder("share of error, error, bias, pixels, surface\n");
    for (int body : bodies.subList(0, Math.min(SHOWN, bodies.size()))) {
      Tally tally = tallies[body];
      out.append(
          String.format(
              Locale.ROOT,
              "%6.2f %%  %6.2f %%  %+6.2f %%  %6d  %s%n",
              100 * tally.off / all,
              100 * tally.off / tally.reference,
              100 * (tally.ours / tally.reference - 1),
              tally.pixels,
              name(scene.bodies().get(body))));
    }
    return out.toString();
  }

  private static String name(Body body) {
    return body.shape().node().location().toString();
  }

  /** The body that all places of a pixel show, or -1. */
  private static int body(RadiosityScene scene, PrimaryHits hits, int pixel) {
    int body = -1;
    for (int i = pixel * hits.places(); i < (pixel + 1) * hits.places(); i++) {
      if (hits.triangle()[i] == Ray.NOTHING) {
        return -1;
      }
      int own = scene.bodyOf()[hits.triangle()[i]];
      if (body >= 0 && body != own) {
        return -1;
      }
      body = own;
    }
    return body;
  }
}
