package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.sampling.PointSet;

/**
 * Computes the unshadowed irradiance of a lamp on a texel in closed form, at the texel's middle
 * where that represents the whole texel. Close to a lamp it does not: on a window's reveal the
 * light begins with a step in the lamp's plane and falls to a half within centimetres, and the
 * surroundings receive most of their light from that strip. There the mean over the texel's square
 * is taken. One per thread.
 */
final class UnhiddenLight {
  /** Distance, in texels, below which a lamp is close. */
  private static final double BESIDE = 4;

  private final PointSet places;
  private final double[] at = new double[3];
  private final double[] one = new double[3];

  /**
   * @param places sample points on a texel, over which the mean is taken
   */
  UnhiddenLight(PointSet places) {
    this.places = places;
  }

  /** Writes the irradiance r, g, b, lx. */
  void of(Lamp lamp, TexelPlace place, double[] out) {
    lamp.unshadowed(place.point, place.normal, out);
    if (!(lamp.away(place.point) < BESIDE * place.size())) {
      return;
    }
    double[] sum = new double[3];
    int count = 0;
    for (int i = 0; i < places.size(); i++) {
      if (place.start(places.x(i), places.y(i), at)) {
        lamp.unshadowed(at, place.normal, one);
        for (int c = 0; c < 3; c++) {
          sum[c] += one[c];
        }
        count++;
      }
    }
    for (int c = 0; c < 3 && count > 0; c++) {
      out[c] = sum[c] / count;
    }
  }
}
