package org.selectiverenderer.radiosity.light;

/**
 * A sample of a lamp from a receiver's point: direction, distance and irradiance. Reused; one per
 * thread.
 */
public final class LightSample {
  /** Unit vector from the receiver to the lamp. */
  public final double[] towards = new double[3];

  /** Distance to the sampled point, metres; infinite for the sun. */
  public double distance;

  /** Irradiance r, g, b at normal incidence, lx. */
  public final double[] light = new double[3];

  /** Working storage for lamps that are sampled by solid angle. */
  final SphericalRectangle rectangle = new SphericalRectangle();

  void black() {
    light[0] = 0;
    light[1] = 0;
    light[2] = 0;
  }

  /** Sets direction and distance; returns the square of the distance. */
  double aim(double[] from, double x, double y, double z) {
    double dx = x - from[0];
    double dy = y - from[1];
    double dz = z - from[2];
    double square = dx * dx + dy * dy + dz * dz;
    distance = Math.sqrt(square);
    double scale = distance > 0 ? 1 / distance : 0;
    towards[0] = dx * scale;
    towards[1] = dy * scale;
    towards[2] = dz * scale;
    return square;
  }

  /** Computes the irradiance r, g, b on a surface with a unit normal; 0 from behind. */
  public void onto(double[] normal, double[] out) {
    double cosine =
        Math.max(0, towards[0] * normal[0] + towards[1] * normal[1] + towards[2] * normal[2]);
    for (int i = 0; i < 3; i++) {
      out[i] = light[i] * cosine;
    }
  }

  void shine(float[] colour, double scale) {
    for (int i = 0; i < 3; i++) {
      light[i] = colour[i] * scale;
    }
  }
}
