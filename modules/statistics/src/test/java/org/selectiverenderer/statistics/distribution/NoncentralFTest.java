package org.selectiverenderer.statistics.distribution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tails against R 4.2.2; the noncentral F against its series in 40 digits (mpmath), as R's own pf
 * stops at 1e-9.
 */
class NoncentralFTest {
  private static final Offset<Double> EXACT = within(1e-11);

  @Test
  void cumulativeProbabilities() {
    assertThat(new NoncentralF(2, 20).cumulative(3, 5)).isEqualTo(0.484131732955971, EXACT);
    assertThat(new NoncentralF(1, 51).cumulative(0.5, 0.3)).isEqualTo(0.455848750871198, EXACT);
    assertThat(new NoncentralF(3, 400).cumulative(250, 700)).isEqualTo(0.734605879115328, EXACT);
    assertThat(new NoncentralF(2.5, 33.3).cumulative(4, 8)).isEqualTo(0.518949912545765, EXACT);
    assertThat(new NoncentralF(2, 20).cumulative(0, 5)).isZero();
    assertThat(new NoncentralF(2, 20).cumulative(Double.POSITIVE_INFINITY, 5)).isEqualTo(1);
  }

  @Test
  void theIntervalsEndsHaveTheObservedFAtTheirTails() {
    NoncentralF distribution = new NoncentralF(2, 51);
    NoncentralF.Interval interval = distribution.interval(5.5, 0.9);
    assertThat(1 - distribution.cumulative(5.5, interval.low())).isEqualTo(0.05, EXACT);
    assertThat(distribution.cumulative(5.5, interval.high())).isEqualTo(0.05, EXACT);
    assertThat(distribution.interval(0.01, 0.9)).isEqualTo(new NoncentralF.Interval(0, 0));
  }

  @Test
  void smallTailsKeepTheirDigits() {
    assertThat(TailProbabilities.f(542.166, 1, 51)).isEqualTo(7.79517312737222e-29, within(1e-39));
    assertThat(TailProbabilities.t(30, 60)).isEqualTo(3.98083397428488e-38, within(1e-48));
    assertThat(TailProbabilities.chiSquared(90, 3)).isEqualTo(2.19057011928531e-19, within(1e-29));
    assertThat(TailProbabilities.f(0, 2, 5)).isEqualTo(1);
    assertThat(TailProbabilities.f(Double.POSITIVE_INFINITY, 2, 5)).isZero();
    assertThat(TailProbabilities.t(-2, 7) + TailProbabilities.t(2, 7)).isEqualTo(1, EXACT);
  }

  /** {@code pf(f, df1, df2, ncp)} of R 4.2.2, which is right there. */
  @Test
  void largeNoncentralities() {
    assertThat(new NoncentralF(1, 51).cumulative(5000, 5000))
        .isEqualTo(0.474054341202617, within(1e-9));
    assertThat(new NoncentralF(2, 20).cumulative(1e4, 15000))
        .isEqualTo(0.776121839356996, within(1e-9));
    assertThat(new NoncentralF(3, 100).cumulative(300, 1000))
        .isEqualTo(0.229064465293128, within(1e-9));
    assertThat(new NoncentralF(2, 51).cumulative(40, 100))
        .isEqualTo(0.193817238780197, within(1e-9));
  }

  /**
   * F of a mean that is ten thousand, a hundred million standard deviations: what R cannot do. The
   * noncentral chi-squared is then as good as its noncentrality, so that l chi / df2 = f.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1e5, 5.4e9, 1e13, 1e17})
  @Timeout(10)
  void hugeFHaveTheirInterval(double f) {
    NoncentralF.Interval interval = new NoncentralF(1, 51).interval(f, 0.9);
    double low = new ChiSquaredDistribution(null, 51).inverseCumulativeProbability(0.05);
    double high = new ChiSquaredDistribution(null, 51).inverseCumulativeProbability(0.95);
    double rest = 10 / Math.sqrt(f);
    assertThat(interval.low() / f).isEqualTo(low / 51, within(1e-9 + rest));
    assertThat(interval.high() / f).isEqualTo(high / 51, within(1e-9 + rest));
  }
}
