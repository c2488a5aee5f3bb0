package org.selectiverenderer.radiosity.solve;

import java.util.List;
import org.selectiverenderer.radiosity.light.LightSample;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.Ray;

/**
 * Monte Carlo estimator of the direct light from the lamps at a point, with shadow rays. One per
 * thread.
 */
public final class DirectLightEstimator {
  /** The bit mask of all lamps. */
  public static final long ALL = -1;

  /**
   * Share of the distance to the lamp at which shadow rays end, so that an emissive surface does
   * not shadow itself.
   */
  private static final double SHORT = 1 - 1e-4;

  private final RadiosityScene scene;
  private final List<LightSource> lamps;
  private final LightSample sample = new LightSample();
  private final Ray ray;

  public DirectLightEstimator(RadiosityScene scene, Ray ray) {
    this.scene = scene;
    this.lamps = scene.lamps();
    this.ray = ray;
  }

  /**
   * Adds the irradiance from one sample point of each lamp.
   *
   * @param point the receiver, off the surface: x, y, z, metres
   * @param normal unit normal
   * @param version the version of an object that the surface belongs to
   * @param s from 0 to 1; with {@code t} it chooses the point on each lamp, a different one for
   *     each lamp
   * @param among bit i: whether lamp i is sampled; lamps from the 64th on always are
   * @param sum irradiance r, g, b, lx; added to
   * @return bit i: whether light arrived from lamp i
   */
  public long add(
      double[] point, double[] normal, int version, double s, double t, long among, double[] sum) {
    long lit = 0;
    for (int i = 0; i < lamps.size(); i++) {
      if (i < Long.SIZE && (among >>> i & 1) == 0) {
        continue;
      }
      double own = s + i * 0.618034;
      double cosine = aim(i, point, normal, own - Math.floor(own), t);
      if (cosine <= 0) {
        continue;
      }
      double passed = passed(point, version) * cosine;
      if (passed > 0) {
        double[] light = sample.light;
        sum[0] += light[0] * passed;
        sum[1] += light[1] * passed;
        sum[2] += light[2] * passed;
        lit |= i < Long.SIZE ? 1L << i : 0;
      }
    }
    return lit;
  }

  /**
   * Samples a point of a lamp; returns the cosine of the angle of incidence on the surface, 0 if no
   * light arrives even unshadowed.
   *
   * @param point the receiver, off the surface: x, y, z, metres
   * @param normal unit normal
   */
  public double aim(int lamp, double[] point, double[] normal, double s, double t) {
    lamps.get(lamp).sample(point, s, t, sample);
    double[] to = sample.towards;
    double cosine = to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2];
    return cosine > 0 && aimed() > 0 ? cosine : 0;
  }

  /**
   * Returns the unshadowed irradiance of the last sample at normal incidence, red, green and blue
   * together.
   */
  public double aimed() {
    return sample.light[0] + sample.light[1] + sample.light[2];
  }

  /** Returns the distance to the last sample, metres; infinite for the sun. */
  double distance() {
    return sample.distance;
  }

  /** Adds the irradiance r, g, b of the last sample at normal incidence, times a factor. */
  void addAimed(double share, double[] sum) {
    for (int c = 0; c < 3; c++) {
      sum[c] += share * sample.light[c];
    }
  }

  /** Casts a shadow ray to the last sample; returns the share of its light that arrives. */
  public double passed(double[] point, int version) {
    ray.from(point, sample.towards);
    ray.length = sample.distance * SHORT;
    return scene.visibility().transmittance(ray, version);
  }
}
