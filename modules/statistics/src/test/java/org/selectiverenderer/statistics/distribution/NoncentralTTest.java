package org.selectiverenderer.statistics.distribution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The noncentral t and the studentized range against R 4.2.2. */
class NoncentralTTest {
  private static final Offset<Double> EXACT = within(1e-10);

  /** {@code pt(t, df, ncp)}. */
  @ParameterizedTest
  @CsvSource({
    "2, 10, 1, 0.807611562530311",
    "-1, 5, 0.5, 0.0824440910569708",
    "0.3, 40, -1, 0.902754330434739",
    "20, 30, 18, 0.743376496707478",
    "5, 3, 4, 0.58626254210172",
    "0, 7, 1.2, 0.115069670221708",
    "35, 500, 36, 0.247189523683489",
  })
  void cumulativeProbabilities(double t, double df, double noncentrality, double p) {
    assertThat(new NoncentralT(df).cumulative(t, noncentrality)).isEqualTo(p, EXACT);
  }

  @Test
  void theIntervalsEndsHaveTheObservedTAtTheirTails() {
    NoncentralT distribution = new NoncentralT(22);
    for (double t : new double[] {-40, -1.3, 0, 2.1, 15, 5e4}) {
      NoncentralT.Interval interval = distribution.interval(t, 0.95);
      assertThat(distribution.cumulative(t, interval.low())).isEqualTo(0.975, within(1e-7));
      assertThat(distribution.cumulative(t, interval.high())).isEqualTo(0.025, within(1e-7));
    }
  }

  /** {@code ptukey(q, means, df, lower.tail = FALSE)}, which is right to about 1e-10. */
  @ParameterizedTest
  @CsvSource({
    "3.5, 3, 20, 0.0558918490820594",
    "1, 4, 51, 0.893820786650368",
    "6, 5, 10, 0.0115579563423422",
    "4.2, 2, 3, 0.0590753007372257",
    "9, 6, 60, 4.42784617749048e-07",
  })
  void theStudentizedRange(double q, int means, double df, double p) {
    assertThat(new StudentizedRange(means, df).upper(q)).isEqualTo(p, within(1e-9));
  }

  /** The range of two is a difference: its tail is that of t. */
  @Test
  void theRangeOfTwoIsThatOfT() {
    assertThat(new StudentizedRange(2, 12).upper(7 * Math.sqrt(2)))
        .isEqualTo(TailProbabilities.tTwoSided(7, 12), within(1e-14));
    assertThat(new StudentizedRange(3, 12).upper(0)).isEqualTo(1);
  }
}
