package org.selectiverenderer.radiosity.texel;

import java.util.Arrays;

/** The noise of records. */
final class RecordNoise {
  /** Light below this share of the mean is dark: nobody sees its noise. */
  private static final double DARK = 0.01;

  private RecordNoise() {}

  static TexelNoise of(LightRecords records) {
    int size = records.size();
    if (size == 0) {
      return TexelNoise.NONE;
    }
    double mean = 0;
    for (int i = 0; i < size; i++) {
      mean += light(records, i) / size;
    }
    double[] shares = new double[size];
    double sum = 0;
    for (int i = 0; i < size; i++) {
      double error = records.numbers()[LightRecords.NUMBERS * i + LightRecords.ERROR];
      shares[i] = mean > 0 ? error / Math.max(DARK * mean, light(records, i)) : 0;
      sum += shares[i];
    }
    Arrays.sort(shares);
    return new TexelNoise(sum / size, shares[(int) (0.95 * (size - 1))], size);
  }

  private static double light(LightRecords records, int i) {
    int at = LightRecords.NUMBERS * i + LightRecords.LIGHT;
    float[] all = records.numbers();
    return (double) all[at] + all[at + 1] + all[at + 2];
  }
}
