package org.selectiverenderer.apartment.textures;

/**
 * Gradient noise over the plane (K. Perlin, Improving Noise, SIGGRAPH 2002), with gradients chosen
 * by a hash of the lattice point instead of a table. The same seed gives the same noise.
 */
final class PerlinNoise {
  /** Scales gradient noise to about -1 to 1. */
  private static final double REACH = 1.4;

  private final int seed;

  PerlinNoise(int seed) {
    this.seed = seed;
  }

  /** Returns a pseudo-random number from 0 to 1 for a lattice point. */
  double dice(int a, int b) {
    return (hash(a, b) >>> 8) / (double) (1 << 24);
  }

  /** Returns noise without repetition, about -1 to 1, with one wave per unit. */
  double at(double x, double y) {
    return at(x, y, Integer.MAX_VALUE, Integer.MAX_VALUE);
  }

  /** Returns noise that repeats after so many units, about -1 to 1, with one wave per unit. */
  double at(double x, double y, int acrossX, int acrossY) {
    int i = (int) Math.floor(x);
    int j = (int) Math.floor(y);
    double u = x - i;
    double v = y - j;
    int left = Math.floorMod(i, acrossX);
    int right = Math.floorMod(i + 1, acrossX);
    int low = Math.floorMod(j, acrossY);
    int high = Math.floorMod(j + 1, acrossY);
    double below = mix(slope(left, low, u, v), slope(right, low, u - 1, v), fade(u));
    double above = mix(slope(left, high, u, v - 1), slope(right, high, u - 1, v - 1), fade(u));
    return REACH * mix(below, above, fade(v));
  }

  /**
   * Returns fractal noise: a sum of octaves, each twice as fine and half as strong, that repeats
   * after so many units; about -1 to 1.
   */
  double layers(int count, double x, double y, int acrossX, int acrossY) {
    double sum = 0;
    double strength = 1;
    int scale = 1;
    for (int layer = 0; layer < count; layer++) {
      boolean endless = acrossX == Integer.MAX_VALUE;
      sum +=
          strength
              * at(
                  x * scale + 17 * layer,
                  y * scale,
                  endless ? acrossX : acrossX * scale,
                  endless ? acrossY : acrossY * scale);
      strength /= 2;
      scale *= 2;
    }
    return sum / 1.6;
  }

  /** Returns fractal noise without repetition. */
  double layers(int count, double x, double y) {
    return layers(count, x, y, Integer.MAX_VALUE, Integer.MAX_VALUE);
  }

  private double slope(int i, int j, double u, double v) {
    int bits = hash(i, j);
    // Eight gradient directions of equal length.
    double a = (bits & 1) == 0 ? 1 : -1;
    double b = (bits & 2) == 0 ? 1 : -1;
    return switch (bits >>> 2 & 3) {
      case 0 -> a * u * Math.sqrt(2);
      case 1 -> a * v * Math.sqrt(2);
      default -> a * u + b * v;
    };
  }

  /** Hashes a and b (the finalizer of MurmurHash3, A. Appleby, 2011). */
  private int hash(int a, int b) {
    int h = seed * 0x9E3779B9 + a * 0x85EBCA6B + b * 0xC2B2AE35;
    h = (h ^ h >>> 16) * 0x85EBCA6B;
    h = (h ^ h >>> 13) * 0xC2B2AE35;
    return h ^ h >>> 16;
  }

  private static double fade(double t) {
    return t * t * t * (t * (6 * t - 15) + 10);
  }

  static double mix(double a, double b, double share) {
    return a + (b - a) * share;
  }

  /** Returns the smoothstep: 0 below {@code from}, 1 above {@code to}, smooth between. */
  static double step(double from, double to, double value) {
    double t = Math.max(0, Math.min(1, (value - from) / (to - from)));
    return t * t * (3 - 2 * t);
  }
}
