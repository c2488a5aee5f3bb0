package org.selectiverenderer.radiosity.texel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;

/** What the filter makes of records on a plane whose light and noise are known. */
class LepskiDenoiserTest {
  private static final int SIDE = 40;
  private static final double SPACING = 0.05;
  private static final double RADIUS = 0.13;

  /** Records on a grid, with normally distributed noise. */
  private static IrradianceCache records(DoubleBinaryOperator light, double noise) {
    Random random = new Random(5);
    IrradianceCache records = new IrradianceCache();
    for (int i = 0; i < SIDE * SIDE; i++) {
      float[] numbers = new float[IrradianceCache.NUMBERS];
      numbers[0] = (float) (i % SIDE * SPACING);
      numbers[2] = (float) (i / SIDE * SPACING);
      numbers[IrradianceCache.NORMAL + 1] = 1;
      numbers[IrradianceCache.RADIUS] = (float) RADIUS;
      numbers[IrradianceCache.ERROR] = (float) (noise + 1e-9);
      numbers[IrradianceCache.RAYS] = 16;
      float value =
          (float) (light.applyAsDouble(numbers[0], numbers[2]) + noise * random.nextGaussian());
      for (int c = 0; c < 3; c++) {
        numbers[IrradianceCache.LIGHT + c] = value / 3;
      }
      records.add(numbers, 0, 0, i);
    }
    records.index();
    return records;
  }

  private interface Look {
    void at(double x, double z, IrradianceRecord evened);
  }

  private static void each(IrradianceCache records, Look look) {
    LepskiDenoiser filter = new LepskiDenoiser(records, new NeighbourRecordSearch.Places(records));
    for (int i = 0; i < records.size(); i++) {
      filter.filter(i, Double.POSITIVE_INFINITY, 1, 0);
      float[] all = records.numbers();
      look.at(all[IrradianceCache.NUMBERS * i], all[IrradianceCache.NUMBERS * i + 2], filter.out);
    }
  }

  @Test
  void lightWithoutNoiseStaysAsItIs() {
    DoubleBinaryOperator bent = (x, z) -> 100 + 20 * x * x + 10 * Math.sin(3 * z);
    each(
        records(bent, 0),
        (x, z, evened) ->
            assertThat(evened.sum()).isCloseTo(bent.applyAsDouble(x, z), within(0.3)));
  }

  @Test
  void noiseOnEvenLightGoesAndTheRestIsTold() {
    double[] sums = new double[4];
    each(
        records((x, z) -> 100 + 10 * x, 8),
        (x, z, evened) -> {
          double off = evened.sum() - 100 - 10 * x;
          sums[0] += off * off;
          sums[1] += evened.error * evened.error;
          sums[2] += off;
          sums[3]++;
        });
    double left = Math.sqrt(sums[0] / sums[3]);
    assertThat(left).isLessThan(8 / 4.0);
    // A plane is tried again and again, so the luckiest is told: no better than by a half.
    assertThat(Math.sqrt(sums[1] / sums[3])).isBetween(left / 1.5, 1.5 * left);
    assertThat(sums[2] / sums[3]).isCloseTo(0, within(0.3));
  }

  /** An edge ten times as high as the noise stays where it is. */
  @Test
  void anEdgeIsNotBlurred() {
    each(
        records((x, z) -> x < 1 ? 100 : 180, 8),
        (x, z, evened) -> {
          if (Math.abs(x - 1) > 2.6 * SPACING) {
            assertThat(evened.sum()).isCloseTo(x < 1 ? 100 : 180, within(16.0));
          }
        });
  }

  /** Along a contact shadow light is even: there the noise goes, across it nothing is blurred. */
  @Test
  void alongAShadowThatIsNarrowNoiseGoesToo() {
    DoubleBinaryOperator shadow = (x, z) -> 100 - 60 * Math.exp(-x / 0.12);
    double[] sums = new double[2];
    each(
        records(shadow, 6),
        (x, z, evened) -> {
          if (x < 0.3) {
            double off = evened.sum() - shadow.applyAsDouble(x, z);
            sums[0] += off * off;
            sums[1]++;
          }
        });
    assertThat(Math.sqrt(sums[0] / sums[1])).isLessThan(6 / 1.8);
  }

  @Test
  void theOthersSideOfAWallSaysNothing() {
    IrradianceCache records = records((x, z) -> 100, 8);
    float[] below = new float[IrradianceCache.NUMBERS];
    below[0] = 1;
    below[1] = -0.001f;
    below[2] = 1;
    below[IrradianceCache.NORMAL + 1] = -1;
    below[IrradianceCache.RADIUS] = (float) RADIUS;
    below[IrradianceCache.ERROR] = 1;
    below[IrradianceCache.RAYS] = 16;
    records.add(below, 0, 0, 0);
    records.index();
    LepskiDenoiser filter = new LepskiDenoiser(records, new NeighbourRecordSearch.Places(records));
    filter.filter(records.size() - 1, Double.POSITIVE_INFINITY, 1, 0);
    assertThat(filter.out.sum()).isZero();
    assertThat(filter.out.error).isEqualTo(1);
  }

  /** As of a wall that goes on two millimetres farther back, behind a skirting board. */
  @Test
  void aDarkSheetRightBehindAFlatOneSaysNothing() {
    IrradianceCache both = records((x, z) -> 100, 4);
    int first = both.size();
    for (int i = 0; i < first; i++) {
      float[] all = both.numbers();
      all[IrradianceCache.NUMBERS * i + IrradianceCache.FLAT] = 1;
      float[] dark =
          Arrays.copyOfRange(all, IrradianceCache.NUMBERS * i, IrradianceCache.NUMBERS * (i + 1));
      dark[1] = -0.002f;
      for (int c = 0; c < 3; c++) {
        dark[IrradianceCache.LIGHT + c] = 0;
      }
      if (dark[0] > 1) {
        dark[0] += (float) (SPACING / 2);
        both.add(dark, 0, 0, first + i);
      }
    }
    both.index();
    int[] seen = {0};
    each(
        both,
        (x, z, evened) -> {
          if (seen[0]++ < first) {
            assertThat(evened.sum()).as("%s %s", x, z).isCloseTo(100, within(16.0));
          }
        });
    assertThat(seen[0]).isGreaterThan(first);
  }

  /** As from a triangle without an area. */
  @Test
  void aRecordThatReachesNothingKeepsItsLight() {
    float[] numbers = new float[IrradianceCache.NUMBERS];
    numbers[IrradianceCache.ERROR] = 2;
    numbers[IrradianceCache.RAYS] = 16;
    numbers[IrradianceCache.LIGHT + 1] = 7;
    IrradianceCache records = new IrradianceCache();
    records.add(numbers, 0, 0, 0);
    records.index();
    each(
        records,
        (x, z, evened) -> {
          assertThat(evened.light).containsExactly(0, 7, 0);
          assertThat(evened.turn).containsOnly(0);
          assertThat(evened.error).isEqualTo(2);
        });
  }
}
