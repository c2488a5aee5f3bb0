package org.selectiverenderer.radiosity.light;

import java.util.Arrays;
import org.selectiverenderer.radiosity.trace.SceneTriangles;

/** An emissive surface as an area light source: triangles of one luminance. */
public final class EmissiveMeshLightSource implements LightSource {
  /**
   * Number of triangles up to which each is integrated in closed form; above it, {@link #PLACES}
   * sample points are taken.
   */
  private static final int MOST_EXACT = 12;

  private static final int PLACES = 48;

  private final SceneTriangles triangles;
  private final int first;
  private final double[] sums;
  private final float[] luminance;
  private final double area;

  // The bounding box.
  private final double[] low = new double[3];
  private final double[] high = new double[3];

  /**
   * @param first the first of its consecutive triangles
   * @param luminance r, g, b of the surface, cd/m2
   */
  public EmissiveMeshLightSource(
      SceneTriangles triangles, int first, int count, float[] luminance) {
    this.triangles = triangles;
    this.first = first;
    this.luminance = luminance;
    sums = new double[count];
    double sum = 0;
    double[] normal = new double[3];
    for (int i = 0; i < count; i++) {
      sum += triangles.normal(first + i, normal);
      sums[i] = sum;
    }
    area = sum;
    Arrays.fill(low, Double.POSITIVE_INFINITY);
    Arrays.fill(high, Double.NEGATIVE_INFINITY);
    for (int i = 9 * first; i < 9 * (first + count); i++) {
      low[i % 3] = Math.min(low[i % 3], triangles.corners()[i]);
      high[i % 3] = Math.max(high[i % 3], triangles.corners()[i]);
    }
  }

  /** Returns the area, square metres. */
  public double area() {
    return area;
  }

  @Override
  public double lumens() {
    double sides = triangles.twoSided()[first] ? 2 : 1;
    double mean = 0.2126 * luminance[0] + 0.7152 * luminance[1] + 0.0722 * luminance[2];
    return Math.PI * area * sides * mean;
  }

  @Override
  public void sample(double[] point, double s, double t, LightSample sample) {
    double wanted = s * area;
    int at = Arrays.binarySearch(sums, wanted);
    at = Math.min(sums.length - 1, at < 0 ? -at - 1 : at + 1);
    double before = at == 0 ? 0 : sums[at - 1];
    double share = sums[at] > before ? (wanted - before) / (sums[at] - before) : 0;
    double root = Math.sqrt(Math.max(0, Math.min(1, share)));
    double[] place = new double[3];
    double[] normal = new double[3];
    triangles.normal(first + at, normal);
    triangles.point(first + at, root * (1 - t), root * t, place);
    double square = sample.aim(point, place[0], place[1], place[2]);
    double[] to = sample.towards;
    double cosine = -(to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2]);
    if (triangles.twoSided()[first]) {
      cosine = Math.abs(cosine);
    }
    if (cosine <= 0) {
      sample.black();
      return;
    }
    sample.shine(luminance, cosine * area / Math.max(square, 0.01 * area));
  }

  @Override
  public void unshadowed(double[] point, double[] normal, double[] out) {
    double factor = sums.length <= MOST_EXACT ? exact(point, normal) : sampled(point, normal);
    for (int i = 0; i < 3; i++) {
      out[i] = luminance[i] * factor;
    }
  }

  private double exact(double[] point, double[] normal) {
    PolygonIrradiance polygon = new PolygonIrradiance();
    double[] corners = new double[9];
    double[] facing = new double[3];
    double sum = 0;
    for (int i = first; i < first + sums.length; i++) {
      double before = 0;
      triangles.normal(i, facing);
      for (int k = 0; k < 9; k++) {
        corners[k] = triangles.corners()[9 * i + k];
        before += k < 3 ? (point[k] - corners[k]) * facing[k] : 0;
      }
      if (before > 0 || before < 0 && triangles.twoSided()[first]) {
        sum += polygon.perLuminance(corners, 3, point, normal);
      }
    }
    return sum;
  }

  /**
   * Returns the mean over fixed sample points, so that neighbouring receivers have the same error.
   */
  private double sampled(double[] point, double[] normal) {
    LightSample sample = new LightSample();
    double[] one = new double[3];
    int brightest = 0;
    for (int i = 1; i < 3; i++) {
      brightest = luminance[i] > luminance[brightest] ? i : brightest;
    }
    double sum = 0;
    for (int i = 0; i < PLACES; i++) {
      double golden = i * 0.618034;
      sample(point, (i + 0.5) / PLACES, golden - Math.floor(golden), sample);
      sample.onto(normal, one);
      sum += one[brightest];
    }
    return sum / PLACES / luminance[brightest];
  }

  @Override
  public double near() {
    return sums.length <= MOST_EXACT ? Math.sqrt(area) : 0;
  }

  @Override
  public double away(double[] point) {
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      double d = Math.max(low[axis] - point[axis], point[axis] - high[axis]);
      square += Math.max(0, d) * Math.max(0, d);
    }
    return Math.sqrt(square);
  }

  @Override
  public boolean hard() {
    return false;
  }
}
