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

  /** What stands near to it, as {@link NearWalls} writes it. */
  final float[] walls = new float[NearWalls.NUMBERS];

  /** Rays that found it. */
  int rays;

  /** False inside of something, or where something covers the place closely. */
  boolean seen;

  double sum() {
    return light[0] + light[1] + light[2];
  }
}
