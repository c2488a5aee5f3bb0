package org.selectiverenderer.radiosity.texel;

/** One irradiance record as the hemisphere estimator returns it. Reused; one per thread. */
final class IrradianceRecord {
  /** Irradiance r, g, b, lx. */
  final double[] light = new double[3];

  /** Rotational gradient of the irradiance: for each of r, g, b a vector of the tangent plane. */
  final double[] turn = new double[9];

  /** Harmonic mean distance to the surfaces that the rays hit, metres. */
  double distance;

  /** Standard error of the irradiance, red, green and blue together. */
  double error;

  /** The walls near the point, as {@link NearbyWallPlanes} writes them. */
  final float[] walls = new float[NearbyWallPlanes.NUMBERS];

  /** Number of rays. */
  int rays;

  /** Whether the point is visible: not inside of a solid and not covered closely. */
  boolean seen;

  double sum() {
    return light[0] + light[1] + light[2];
  }
}
