package org.selectiverenderer.radiosity.light;

/**
 * A bright rectangle that shines to one side, such as a window or a ceiling lamp. Diffuse: seen
 * from everywhere it has the same luminance.
 *
 * @param centre x, y, z
 * @param half half of its width as a vector
 * @param up half of its height as a vector
 * @param axis unit vector in which it shines
 * @param luminance r, g, b, cd/m2
 */
public record RectangleLamp(
    double[] centre,
    double[] half,
    double[] up,
    double[] axis,
    float[] luminance,
    double area,
    double lumens)
    implements Lamp {

  @Override
  public void sample(double[] point, double s, double t, LampSample sample) {
    double a = 2 * s - 1;
    double b = 2 * t - 1;
    double square =
        sample.aim(
            point,
            centre[0] + a * half[0] + b * up[0],
            centre[1] + a * half[1] + b * up[1],
            centre[2] + a * half[2] + b * up[2]);
    double[] to = sample.towards;
    double cosine = -(to[0] * axis[0] + to[1] * axis[1] + to[2] * axis[2]);
    if (cosine <= 0) {
      sample.black();
      return;
    }
    // Nearer than a tenth of its side the sum over single places would have peaks.
    sample.shine(luminance, cosine * area / Math.max(square, 0.01 * area));
  }

  @Override
  public void unshadowed(double[] point, double[] normal, double[] out) {
    double before = 0;
    for (int i = 0; i < 3; i++) {
      before += (point[i] - centre[i]) * axis[i];
    }
    double factor = 0;
    if (before > 0) {
      double[] corners = new double[12];
      for (int i = 0; i < 12; i++) {
        int corner = i / 3;
        double across = corner == 0 || corner == 3 ? -half[i % 3] : half[i % 3];
        corners[i] = centre[i % 3] + across + (corner < 2 ? -up[i % 3] : up[i % 3]);
      }
      factor = new PolygonLight().perLuminance(corners, 4, point, normal);
    }
    for (int i = 0; i < 3; i++) {
      out[i] = luminance[i] * factor;
    }
  }

  @Override
  public double near() {
    return Math.sqrt(area);
  }

  @Override
  public boolean hard() {
    return false;
  }
}
