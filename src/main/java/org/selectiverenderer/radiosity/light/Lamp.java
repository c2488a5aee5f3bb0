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

  /**
   * The irradiance from the whole lamp on a surface if nothing is in its way, lx: a closed form
   * where there is one.
   *
   * @param point x, y, z, metres
   * @param normal unit normal of the surface
   * @param out gets r, g, b
   */
  void unshadowed(double[] point, double[] normal, double[] out);

  /**
   * Metres: of what is nearer, single places are no fair sample, as their light changes too much
   * from one to the next; {@link #unshadowed} is right there, too. 0 where that is no better.
   */
  double near();

  /** No farther than it is from a point, metres; infinite for the sun. */
  double away(double[] point);

  /** Whether it is a point or infinitely far, so that its shadows have hard edges. */
  boolean hard();

  /** What it emits, lm; for what is infinitely far away the lux that arrive. */
  double lumens();
}
