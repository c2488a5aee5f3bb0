package org.selectiverenderer.radiosity.bake;

import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.solve.RadiositySolution;

/**
 * Tone mapping from radiance to display colours: partial chromatic adaptation to the colour of the
 * scene's light (von Kries, on linear red, green and blue), then the global operator of Reinhard et
 * al. 2002 (equations 1, 2 and 4) on luminance with hues kept, then the display's encoding (sRGB).
 * The log-average luminance of the lit surfaces becomes {@link #KEY}; {@link #BURN} and more is
 * white.
 *
 * @param scale factor of luminance before the curve
 * @param red adaptation factor of red light, and so {@code green} and {@code blue}; light of the
 *     average colour keeps its luminance
 */
public record ReinhardToneMapping(double scale, double red, double green, double blue) {
  /** The key value: scaled log-average luminance, that of a bright room. */
  static final double KEY = 0.62;

  /** The white point: the scaled luminance that becomes white. */
  static final double BURN = 5;

  /** Degree of chromatic adaptation, 0 none to 1 full, for a room seen on a display. */
  private static final double ADAPTATION = 0.6;

  /** Largest adaptation factor of a channel; its inverse is the least one. */
  private static final double MOST_GAIN = 2;

  /**
   * Surfaces darker than this share of the brightest, such as outsides of walls, do not count in
   * the average.
   */
  private static final double UNSEEN = 1e-3;

  /**
   * @param stops exposure compensation: stops brighter (above 0) or darker than the automatic
   *     exposure
   */
  public static ReinhardToneMapping of(
      RadiosityScene scene, RadiositySolution solution, double stops) {
    var patches = solution.patches();
    double brightest = 0;
    for (int patch = 0; patch < patches.count(); patch++) {
      brightest = Math.max(brightest, luminance(solution, patch));
    }
    double sum = 0;
    double area = 0;
    double[] light = new double[3];
    for (int patch = 0; patch < patches.count(); patch++) {
      double luminance = luminance(solution, patch);
      boolean counts =
          luminance > UNSEEN * brightest
              && !solution.buried()[patch]
              && scene.versions().isReference(scene.triangles().version()[patches.triangle(patch)]);
      if (counts) {
        sum += patches.area(patch) * StrictMath.log(luminance);
        area += patches.area(patch);
        addColour(solution, patch, patches.area(patch), light);
      }
    }
    double average = area > 0 ? StrictMath.exp(sum / area) : Photometry.WHITE;
    double[] gain = gains(light);
    return new ReinhardToneMapping(
        KEY / average * StrictMath.pow(2, stops), gain[0], gain[1], gain[2]);
  }

  /**
   * Adds the colour of the light that arrives at a patch, scaled to luminance 1, times the area.
   */
  private static void addColour(RadiositySolution solution, int patch, double area, double[] sum) {
    double[] arriving = new double[3];
    for (int c = 0; c < 3; c++) {
      arriving[c] = solution.direct()[3 * patch + c] + solution.indirect()[3 * patch + c];
    }
    double luminance = Photometry.luminance(arriving[0], arriving[1], arriving[2]);
    for (int c = 0; c < 3 && luminance > 0; c++) {
      sum[c] += area * arriving[c] / luminance;
    }
  }

  private static double[] gains(double[] light) {
    double luminance = Photometry.luminance(light[0], light[1], light[2]);
    double[] gain = {1, 1, 1};
    for (int c = 0; c < 3 && luminance > 0; c++) {
      double wanted = StrictMath.pow(Math.max(1e-6, light[c] / luminance), -ADAPTATION);
      gain[c] = Math.max(1 / MOST_GAIN, Math.min(MOST_GAIN, wanted));
    }
    double after = Photometry.luminance(light[0] * gain[0], light[1] * gain[1], light[2] * gain[2]);
    for (int c = 0; c < 3 && after > 0; c++) {
      gain[c] *= luminance / after;
    }
    return gain;
  }

  private static double luminance(RadiositySolution solution, int patch) {
    float[] all = solution.reflected();
    return Photometry.luminance(all[3 * patch], all[3 * patch + 1], all[3 * patch + 2]);
  }

  /**
   * Returns the tone-mapped value of a luminance as a share of white, before the display's
   * encoding.
   */
  public double share(double luminance) {
    double x = luminance * scale;
    return x * (1 + x / (BURN * BURN)) / (1 + x);
  }

  /**
   * Computes the display colour of a radiance.
   *
   * @param red radiance, cd/m2, and so {@code green} and {@code blue}
   * @param out receives r, g, b, 0 .. 1
   */
  public void colour(double red, double green, double blue, float[] out, int at) {
    double r = this.red * red;
    double g = this.green * green;
    double b = this.blue * blue;
    double luminance = Photometry.luminance(r, g, b);
    double share = share(luminance);
    double gain = luminance > 0 ? share / luminance : 0;
    double most = Math.max(r, Math.max(g, b)) * gain;
    // A colour with a channel above 1 is desaturated instead of clipped, which would change its
    // hue.
    double grey = most > 1 && most > share ? Math.max(0, (1 - share) / (most - share)) : 1;
    double white = Math.min(1, share);
    out[at] = (float) Photometry.display(white + grey * (r * gain - share));
    out[at + 1] = (float) Photometry.display(white + grey * (g * gain - share));
    out[at + 2] = (float) Photometry.display(white + grey * (b * gain - share));
  }
}
