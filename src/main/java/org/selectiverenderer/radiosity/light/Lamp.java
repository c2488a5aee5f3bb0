package org.selectiverenderer.radiosity.light;

/** A light whose places are sampled one by one. Immutable; for several threads. */
public sealed interface Lamp permits PointLamp, SunLamp, RectangleLamp, GlowLamp {

  /**
   * The light from a place of the lamp to a point.
   *
   * @param point x, y, z, metres
   * @param s from 0 to 1, with {@code t} the place on the lamp
   * @param sample gets direction, distance and the irradiance at right angles if the whole lamp
   *     were at that place; black where none arrives
   */
  void sample(double[] point, double s, double t, LampSample sample);

  /** What it emits, lm; for what is infinitely far away the lux that arrive. */
  double lumens();
}
