package org.selectiverenderer.radiosity.light;

/** A light source that is sampled point by point. Immutable; for several threads. */
public sealed interface LightSource
    permits PointLightSource,
        DirectionalLightSource,
        RectangleLightSource,
        EmissiveMeshLightSource {

  /**
   * Samples the light from a point of the lamp to a receiver.
   *
   * @param point the receiver: x, y, z, metres
   * @param s from 0 to 1; with {@code t} it chooses the point on the lamp
   * @param sample receives direction, distance and the irradiance at normal incidence as if the
   *     whole lamp were at that point; black where no light arrives
   */
  void sample(double[] point, double s, double t, LightSample sample);

  /**
   * Computes the unshadowed irradiance from the whole lamp on a surface, lx, in closed form where
   * there is one.
   *
   * @param point the receiver: x, y, z, metres
   * @param normal unit normal of the receiving surface
   * @param out receives r, g, b
   */
  default void unshadowed(double[] point, double[] normal, double[] out) {
    // Every sample of a lamp without extent is the whole lamp.
    LightSample sample = new LightSample();
    sample(point, 0.5, 0.5, sample);
    sample.onto(normal, out);
  }

  /**
   * Returns the distance, metres, within which single sample points of the lamp are too noisy,
   * since their light varies too much, and {@link #unshadowed} is to be used instead; 0 where that
   * is no better.
   */
  default double near() {
    return 0;
  }

  /**
   * Returns a lower bound of the distance from a point to the lamp, metres; infinite for the sun.
   */
  double away(double[] point);

  /** Returns whether the lamp is a point or infinitely far, so that its shadows have hard edges. */
  boolean hard();

  /** Returns the luminous flux, lm; for a lamp infinitely far away the illuminance, lx. */
  double lumens();
}
