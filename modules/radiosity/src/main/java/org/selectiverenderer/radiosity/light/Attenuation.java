package org.selectiverenderer.radiosity.light;

/** The attenuation of a light source's intensity with distance. */
public sealed interface Attenuation {
  /** Returns the factor of the intensity at a distance in metres. */
  double at(double distance);

  /** The inverse square law, constant within a centimetre. */
  record InverseSquare() implements Attenuation {
    private static final double NEAREST = 1e-4;

    @Override
    public double at(double distance) {
      return 1 / Math.max(NEAREST, distance * distance);
    }
  }

  /**
   * The attenuation of X3D lights: 1 / max(c + l d + q d2, 1) up to a radius (X3D 4.0, 17.2.1.3).
   */
  record X3dAttenuation(double constant, double linear, double quadratic, double radius)
      implements Attenuation {
    @Override
    public double at(double distance) {
      double sum = constant + linear * distance + quadratic * distance * distance;
      return distance > radius ? 0 : 1 / Math.max(1, sum);
    }
  }
}
