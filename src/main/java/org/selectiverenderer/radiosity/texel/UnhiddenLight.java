package org.selectiverenderer.radiosity.texel;

import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.sampling.PointSet;

/**
 * What falls on a texel from a lamp if nothing is in the way: in closed form, in the texel's middle
 * where that is as good as all of it. Beside a lamp it is not: on a window's reveal light begins
 * with a step in the lamp's plane and falls to a half within centimetres, and what is around it has
 * most of its light from that strip. There it is the mean over the texel's square. One per thread.
 */
final class UnhiddenLight {
  /** Lamps nearer than so many texels. */
  private static final double BESIDE = 4;

  private final PointSet places;
  private final double[] at = new double[3];
  private final double[] one = new double[3];

  /**
   * @param places on a texel, of which the mean is taken
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
