package org.selectiverenderer.radiosity.light;

/** How light grows weaker with the distance. */
public sealed interface Falloff {
  /** The share of the intensity that arrives, per unit. */
  double at(double distance);

  /** The inverse square law; within a centimetre nothing grows any more. */
  record Square() implements Falloff {
    private static final double NEAREST = 1e-4;

    @Override
    public double at(double distance) {
      return 1 / Math.max(NEAREST, distance * distance);
    }
  }

  /** 1 / max(c + l d + q d2, 1) up to a radius (X3D 4.0, 17.2.1.3), as X3D lights are drawn. */
  record Attenuation(double constant, double linear, double quadratic, double radius)
      implements Falloff {
    @Override
    public double at(double distance) {
      double sum = constant + linear * distance + quadratic * distance * distance;
      return distance > radius ? 0 : 1 / Math.max(1, sum);
    }
  }
}
