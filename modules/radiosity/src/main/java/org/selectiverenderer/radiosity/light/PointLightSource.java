package org.selectiverenderer.radiosity.light;

/**
 * A point or spot light source.
 *
 * @param place position x, y, z, metres
 * @param candela intensity r, g, b on the axis of the beam, cd
 * @param axis unit vector along the beam of a spot light
 * @param beamCosine cosine of the angle up to which the intensity is full; -1 for a point light
 * @param cutOffCosine cosine of the angle from which on the intensity is 0; -2 for a point light
 */
public record PointLightSource(
    double[] place,
    float[] candela,
    double[] axis,
    double beamCosine,
    double cutOffCosine,
    Attenuation falloff,
    double lumens)
    implements LightSource {

  @Override
  public void sample(double[] point, double s, double t, LightSample sample) {
    sample.aim(point, place[0], place[1], place[2]);
    double[] to = sample.towards;
    double cosine = -(to[0] * axis[0] + to[1] * axis[1] + to[2] * axis[2]);
    double beam = cosine >= beamCosine ? 1 : 0;
    if (beam == 0 && cosine > cutOffCosine) {
      // Linear in the cosine; X3D 4.0, 17.4.3 asks for linear in the angle, which differs little.
      beam = (cosine - cutOffCosine) / (beamCosine - cutOffCosine);
    }
    sample.shine(candela, beam * falloff.at(sample.distance));
  }

  @Override
  public double away(double[] point) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
      square += (point[i] - place[i]) * (point[i] - place[i]);
    }
    return Math.sqrt(square);
  }

  @Override
  public boolean hard() {
    return true;
  }
}
