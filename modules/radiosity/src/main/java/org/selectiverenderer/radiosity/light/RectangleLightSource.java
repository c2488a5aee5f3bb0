package org.selectiverenderer.radiosity.light;

/**
 * A diffuse rectangular area light source that shines to one side, such as a window or a ceiling
 * lamp: it has the same luminance from every direction.
 *
 * @param centre x, y, z, metres
 * @param half vector from the centre to the right edge
 * @param up vector from the centre to the upper edge
 * @param axis unit normal of the side that shines
 * @param luminance r, g, b of the rectangle, cd/m2
 */
public record RectangleLightSource(
    double[] centre,
    double[] half,
    double[] up,
    double[] axis,
    float[] luminance,
    double area,
    double lumens)
    implements LightSource {

  /**
   * Distance, in units of the side of a square of its area, up to which sample points are uniform
   * over the solid angle instead of over the area.
   */
  private static final double NEAR = 2;

  @Override
  public void sample(double[] point, double s, double t, LightSample sample) {
    double height = along(axis, point);
    if (!(height > 0)) {
      sample.black();
      return;
    }
    double square = 0;
    for (int i = 0; i < 3; i++) {
      double d = point[i] - centre[i];
      square += d * d;
    }
    if (square > NEAR * NEAR * area) {
      far(point, 2 * s - 1, 2 * t - 1, sample);
      return;
    }
    double width = Math.sqrt(squared(half));
    double tall = Math.sqrt(squared(up));
    double x = along(half, point) / width;
    double y = along(up, point) / tall;
    SphericalRectangle seen = sample.rectangle;
    double solidAngle = seen.look(-width - x, width - x, -tall - y, tall - y, height);
    seen.place(s, t);
    aim(point, seen.across / width - 1, seen.along / tall - 1, sample);
    sample.shine(luminance, solidAngle);
  }

  /** Returns the dot product of a vector and the way from the centre to a point. */
  private double along(double[] vector, double[] point) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum += (point[i] - centre[i]) * vector[i];
    }
    return sum;
  }

  private static double squared(double[] vector) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      sum += vector[i] * vector[i];
    }
    return sum;
  }

  private void far(double[] point, double a, double b, LightSample sample) {
    double square = aim(point, a, b, sample);
    double[] to = sample.towards;
    double cosine = -(to[0] * axis[0] + to[1] * axis[1] + to[2] * axis[2]);
    sample.shine(luminance, Math.max(0, cosine) * area / square);
  }

  private double aim(double[] point, double a, double b, LightSample sample) {
    return sample.aim(
        point,
        centre[0] + a * half[0] + b * up[0],
        centre[1] + a * half[1] + b * up[1],
        centre[2] + a * half[2] + b * up[2]);
  }

  @Override
  public void unshadowed(double[] point, double[] normal, double[] out) {
    double factor = 0;
    if (along(axis, point) > 0) {
      double[] corners = new double[12];
      for (int i = 0; i < 12; i++) {
        int corner = i / 3;
        double across = corner == 0 || corner == 3 ? -half[i % 3] : half[i % 3];
        corners[i] = centre[i % 3] + across + (corner < 2 ? -up[i % 3] : up[i % 3]);
      }
      factor = new PolygonIrradiance().perLuminance(corners, 4, point, normal);
    }
    for (int i = 0; i < 3; i++) {
      out[i] = luminance[i] * factor;
    }
  }

  @Override
  public double away(double[] point) {
    double height = along(axis, point);
    double width = squared(half);
    double tall = squared(up);
    double x = Math.max(0, (Math.abs(along(half, point)) - width) / Math.sqrt(width));
    double y = Math.max(0, (Math.abs(along(up, point)) - tall) / Math.sqrt(tall));
    return Math.sqrt(height * height + x * x + y * y);
  }

  @Override
  public boolean hard() {
    return false;
  }
}
