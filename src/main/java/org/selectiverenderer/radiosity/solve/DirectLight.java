package org.selectiverenderer.radiosity.solve;

import java.util.List;
import org.selectiverenderer.radiosity.light.Lamp;
import org.selectiverenderer.radiosity.light.LampSample;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.trace.Ray;

/** Light that comes straight from the lamps to a point. One per thread. */
public final class DirectLight {
  /** All lamps. */
  public static final long ALL = -1;

  /**
   * Shadow rays end this share before the lamp, so that a glowing surface is not in its own way.
   */
  private static final double SHORT = 1 - 1e-4;

  private final LightScene scene;
  private final List<Lamp> lamps;
  private final LampSample sample = new LampSample();
  private final Ray ray;

  public DirectLight(LightScene scene, Ray ray) {
    this.scene = scene;
    this.lamps = scene.lamps();
    this.ray = ray;
  }

  /**
   * Adds the irradiance from one place of each lamp.
   *
   * @param point off the surface
   * @param normal unit normal
   * @param version that the surface belongs to
   * @param s from 0 to 1, with {@code t} the place on each lamp; lamps after the first take others
   * @param among bit i: whether lamp i counts; those from the 64th on always do
   * @param sum r, g, b, lx
   * @return bit i: whether light came from lamp i
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
   * Turns to a place of a lamp; returns the cosine of the angle at which its light falls on a
   * surface, 0 if none does.
   *
   * @param point off the surface
   * @param normal unit normal
   */
  public double aim(int lamp, double[] point, double[] normal, double s, double t) {
    lamps.get(lamp).sample(point, s, t, sample);
    double[] to = sample.towards;
    double cosine = to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2];
    return cosine > 0 && aimed() > 0 ? cosine : 0;
  }

  /** The light of the last place aimed at: red, green and blue together, at right angles. */
  public double aimed() {
    return sample.light[0] + sample.light[1] + sample.light[2];
  }

  /** How far the last place aimed at is, metres; infinite for the sun. */
  double distance() {
    return sample.distance;
  }

  /** Adds the light of the last place aimed at, r, g, b, at right angles, times a share. */
  void addAimed(double share, double[] sum) {
    for (int c = 0; c < 3; c++) {
      sum[c] += share * sample.light[c];
    }
  }

  /** The share of light that arrives from the last place aimed at: one ray. */
  public double passed(double[] point, int version) {
    ray.from(point, sample.towards);
    ray.length = sample.distance * SHORT;
    return scene.visibility().transmittance(ray, version);
  }
}
