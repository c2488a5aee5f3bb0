package org.selectiverenderer.browser.nodes.particle;

import java.util.SplittableRandom;
import org.joml.Vector3d;

/** The random numbers of one particle system, reproducible by their seed. */
final class ParticleRandom {
  private final SplittableRandom random;

  ParticleRandom(long seed) {
    random = new SplittableRandom(seed);
  }

  /** Returns a uniform value from 0 to below 1. */
  double part() {
    return random.nextDouble();
  }

  /** Returns a uniform value between two values. */
  double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  /**
   * Returns a uniform value from {@code value * (1 - variation)} to {@code value * (1 +
   * variation)}, and not below 0.
   */
  double around(double value, double variation) {
    return Math.max(0, value * (1 + variation * between(-1, 1)));
  }

  /** Returns a unit vector, uniform on the sphere. */
  Vector3d direction() {
    double z = between(-1, 1);
    double angle = between(0, 2 * Math.PI);
    double across = Math.sqrt(1 - z * z);
    return new Vector3d(across * Math.cos(angle), across * Math.sin(angle), z);
  }

  /**
   * Returns a unit vector, uniform in a cone about an axis.
   *
   * @param axis the cone's axis, of unit length
   * @param angle the largest angle to the axis, in radians
   */
  Vector3d cone(Vector3d axis, double angle) {
    double along = between(Math.cos(Math.max(0, Math.min(angle, Math.PI))), 1);
    double around = between(0, 2 * Math.PI);
    double across = Math.sqrt(Math.max(0, 1 - along * along));
    Vector3d side = axis.orthogonalizeUnit(someOther(axis), new Vector3d());
    Vector3d up = axis.cross(side, new Vector3d());
    return new Vector3d(axis)
        .mul(along)
        .fma(across * Math.cos(around), side)
        .fma(across * Math.sin(around), up);
  }

  private static Vector3d someOther(Vector3d axis) {
    return Math.abs(axis.x) < 0.9 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
  }
}
