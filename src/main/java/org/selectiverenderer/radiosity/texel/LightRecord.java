package org.selectiverenderer.radiosity.texel;

/** What a hemisphere of rays finds; used again and again by one thread. */
final class LightRecord {
  /** Irradiance r, g, b, lx. */
  final double[] light = new double[3];

  /** How it changes when the normal turns: a vector of the tangent plane for each of r, g, b. */
  final double[] turn = new double[9];

  /** The harmonic mean of how far what is seen is, metres. */
  double distance;

  /** The standard error of the light, red, green and blue together. */
  double error;

  /** False inside of something, or where something covers the place closely. */
  boolean seen;

  double sum() {
    return light[0] + light[1] + light[2];
  }

  /**
   * Takes the mean with another one.
   *
   * @param times how many times as much this one counts
   */
  void join(LightRecord other, int times) {
    double own = times / (times + 1.0);
    for (int i = 0; i < 3; i++) {
      light[i] = own * light[i] + (1 - own) * other.light[i];
    }
    for (int i = 0; i < 9; i++) {
      turn[i] = own * turn[i] + (1 - own) * other.turn[i];
    }
    distance = 1 / (own / distance + (1 - own) / other.distance);
    double a = own * error;
    double b = (1 - own) * other.error;
    error = Math.sqrt(a * a + b * b);
  }
}
