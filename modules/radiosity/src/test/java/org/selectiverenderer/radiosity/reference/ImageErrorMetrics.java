package org.selectiverenderer.radiosity.reference;

import java.util.Locale;
import org.selectiverenderer.radiosity.scene.Photometry;

/**
 * How far a picture is from the reference, in luminance of reflected light (what glows is left out:
 * it is the same in both and would make errors look small); background pixels do not count.
 *
 * @param error the mean of |ours - reference| over the mean of the reference
 * @param relative the mean of |ours - reference| / reference over pixels
 * @param bias the mean of ours over that of the reference, less 1
 * @param noise what {@code error} is of the reference alone: half of the mean difference of its two
 *     halves over its mean
 * @param relativeNoise likewise, of {@code relative}
 * @param squared root of the mean square of ours - reference over the mean of the reference, the
 *     reference's noise taken out: (ours - one half) times (ours - the other half)
 * @param most the largest |ours - reference| over the mean of the reference
 * @param column of the pixel where that is
 * @param row likewise, from the top
 * @param within share of pixels with {@code relative} at most 2 %
 */
record ImageErrorMetrics(
    double error,
    double relative,
    double bias,
    double noise,
    double relativeNoise,
    double squared,
    double most,
    int column,
    int row,
    double within) {
  /** Share of a pixel that must show a surface for the pixel to count. */
  private static final double COUNTS = 0.999;

  /** Pixels darker than this share of the mean have no relative error worth a figure. */
  private static final double DARK = 1e-4;

  private static final double NEAR = 0.02;

  static ImageErrorMetrics of(PrimaryHits hits, double[] ours, ReferenceImage reference) {
    double[] all = reference.light();
    double[] even = reference.half(0);
    double[] odd = reference.half(1);
    double mean = 0;
    double sum = 0;
    int count = 0;
    for (int i = 0; i < hits.pixels(); i++) {
      if (hits.covered(i) > COUNTS) {
        mean += luminance(all, i);
        sum += luminance(ours, i);
        count++;
      }
    }
    double difference = 0;
    double relative = 0;
    double noise = 0;
    double relativeNoise = 0;
    double product = 0;
    double most = 0;
    int worst = 0;
    int near = 0;
    int bright = 0;
    for (int i = 0; i < hits.pixels(); i++) {
      if (hits.covered(i) <= COUNTS) {
        continue;
      }
      double is = luminance(ours, i);
      double a = luminance(even, i);
      double b = luminance(odd, i);
      double wanted = luminance(all, i);
      double off = Math.abs(is - wanted);
      difference += off;
      noise += Math.abs(a - b) / 2;
      product += (is - a) * (is - b);
      if (off > most) {
        most = off;
        worst = i;
      }
      if (wanted > DARK * mean / count) {
        bright++;
        relative += off / wanted;
        relativeNoise += Math.abs(a - b) / 2 / wanted;
        near += off <= NEAR * wanted ? 1 : 0;
      }
    }
    return new ImageErrorMetrics(
        difference / mean,
        relative / bright,
        sum / mean - 1,
        noise / mean,
        relativeNoise / bright,
        Math.sqrt(Math.max(0, product / count)) * count / mean,
        most * count / mean,
        worst % hits.width(),
        worst / hits.width(),
        (double) near / bright);
  }

  static double luminance(double[] rgb, int pixel) {
    return Photometry.luminance(rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]);
  }

  /** For people. */
  String text() {
    return String.format(
        Locale.ROOT,
        """
        mean error                 %6.2f %%  (mean |ours - reference| / mean reference; noise %.2f %%)
        mean of relative errors    %6.2f %%  (noise %.2f %%)
        root mean square error     %6.2f %%  (without the reference's noise)
        bias                       %+6.2f %%
        largest error              %6.2f %%  of the mean, at pixel %d, %d
        pixels within 2 %%          %6.2f %%
        """,
        100 * error,
        100 * noise,
        100 * relative,
        100 * relativeNoise,
        100 * squared,
        100 * bias,
        100 * most,
        column,
        row,
        100 * within);
  }
}
