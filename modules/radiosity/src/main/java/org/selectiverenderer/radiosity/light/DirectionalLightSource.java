package org.selectiverenderer.radiosity.light;

/**
 * A directional light source.
 *
 * @param towards unit vector from the scene to the light source
 * @param lux illuminance r, g, b at normal incidence
 */
public record DirectionalLightSource(double[] towards, float[] lux, double lumens)
    implements LightSource {

  @Override
  public void sample(double[] point, double s, double t, LightSample sample) {
    System.arraycopy(towards, 0, sample.towards, 0, 3);
    sample.distance = Double.POSITIVE_INFINITY;
    sample.shine(lux, 1);
  }

  @Override
  public double away(double[] point) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public boolean hard() {
    return true;
  }
}
