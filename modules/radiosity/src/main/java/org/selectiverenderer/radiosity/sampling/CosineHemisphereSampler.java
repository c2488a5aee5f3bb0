package org.selectiverenderer.radiosity.sampling;

/**
 * Cosine-weighted directions of the hemisphere about +z: their density is the cosine of the angle
 * with +z over pi, so the mean radiance over them is the irradiance over pi (Malley's method).
 */
public final class CosineHemisphereSampler {
  private final float[] xyz;

  public CosineHemisphereSampler(SobolPointSet points) {
    xyz = new float[3 * points.size()];
    for (int i = 0; i < points.size(); i++) {
      double radius = Math.sqrt(points.x(i));
      double angle = 2 * Math.PI * points.y(i);
      xyz[3 * i] = (float) (radius * StrictMath.cos(angle));
      xyz[3 * i + 1] = (float) (radius * StrictMath.sin(angle));
      xyz[3 * i + 2] = (float) Math.sqrt(Math.max(0, 1 - points.x(i)));
    }
  }

  public int size() {
    return xyz.length / 3;
  }

  /**
   * Computes the i-th direction of the hemisphere about a normal, in an orthonormal basis built
   * from the normal (Duff et al. 2017).
   *
   * @param n unit normal
   * @param out receives x, y, z
   */
  public void about(double[] n, int i, double[] out) {
    double sign = n[2] < 0 ? -1 : 1;
    double a = -1 / (sign + n[2]);
    double b = n[0] * n[1] * a;
    double x = xyz[3 * i];
    double y = xyz[3 * i + 1];
    double z = xyz[3 * i + 2];
    out[0] = x * (1 + sign * n[0] * n[0] * a) + y * b + z * n[0];
    out[1] = x * sign * b + y * (sign + n[1] * n[1] * a) + z * n[1];
    out[2] = -x * sign * n[0] - y * n[1] + z * n[2];
  }
}
