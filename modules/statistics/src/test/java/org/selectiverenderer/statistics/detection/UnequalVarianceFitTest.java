package org.selectiverenderer.statistics.detection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;

class UnequalVarianceFitTest {
  @Test
  void answersAreRatingsFromSurelyNoToSurelyYes() {
    RatingCounts ratings =
        RatingCounts.of(
            List.of(
                answer(true, true, 5),
                answer(true, true, 1),
                answer(true, false, 1),
                answer(false, false, 5),
                answer(false, false, 0)));
    assertThat(ratings.signal()).containsExactly(0, 0, 0, 0, 1, 1, 0, 0, 0, 1);
    assertThat(ratings.noise()).containsExactly(1, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  /** Three categories have as many parameters as free rates: the fit gives them back. */
  @Test
  void ofThreeCategoriesTheFitIsTheRates() {
    // z of .3 and .8 against z of .1 and .5: -0.5244, 0.8416; -1.2816, 0
    UnequalVarianceFit fit =
        UnequalVarianceFit.of(new RatingCounts(List.of(30, 50, 20), List.of(10, 40, 50)));
    assertThat(fit.slope().value())
        .isCloseTo(1.2815515655 / (0.5244005127 + 0.8416212336), within(1e-8));
    assertThat(fit.criteria()).hasSize(2);
    assertThat(fit.criteria().get(0).value()).isCloseTo(-0.5244005127, within(1e-8));
    assertThat(fit.g2()).isCloseTo(0, within(1e-9));
    assertThat(fit.df()).isZero();
    assertThat(fit.fitP()).isNaN();
    assertThat(fit.hitRate(0.2)).isCloseTo(0.5, within(1e-8));
    assertThat(fit.hitRate(0.7)).isCloseTo(0.9, within(1e-8));
  }

  @Test
  void ratingsThatSeparateTheKindsHaveNoFiniteFitAndSayWhy() {
    UnequalVarianceFit fit =
        UnequalVarianceFit.of(new RatingCounts(List.of(5, 6, 0, 0), List.of(0, 0, 4, 7)));
    assertThat(fit.flaw()).hasValueSatisfying(why -> assertThat(why).contains("finite maximum"));
    assertThat(fit.distance().value()).isNaN();
    assertThat(fit.slopeP()).isNaN();
  }

  @Test
  void ratingsOfFewCategoriesOrOneKindHaveNoFit() {
    assertThat(UnequalVarianceFit.of(new RatingCounts(List.of(5, 0, 3), List.of(2, 0, 9))).flaw())
        .contains("fewer than 3 of the ratings were used");
    RatingCounts absent = new RatingCounts(List.of(5, 1, 3), List.of(0, 0, 0));
    assertThat(UnequalVarianceFit.of(absent).flaw()).contains("no rating of present objects");
    assertThat(EmpiricalRoc.of(absent).area()).isNaN();
    assertThat(EmpiricalRoc.of(new RatingCounts(List.of(0), List.of(0))).flaw())
        .contains("no rating of present and absent objects");
  }

  /** Whatever few answers a participant gives, there is a fit or a reason, and quickly. */
  @Test
  void everySmallTableEndsInAFitOrAReason() {
    Random random = new Random(3);
    int fitted = 0;
    for (int i = 0; i < 500; i++) {
      Integer[] noise = new Integer[10];
      Integer[] signal = new Integer[10];
      Arrays.fill(noise, 0);
      Arrays.fill(signal, 0);
      for (int answer = 0; answer < 2 + i % 17; answer++) {
        noise[(int) Math.max(0, Math.min(9, 3.5 + 2.5 * random.nextGaussian()))]++;
        signal[(int) Math.max(0, Math.min(9, 6 + 3 * random.nextGaussian()))]++;
      }
      UnequalVarianceFit fit =
          UnequalVarianceFit.of(new RatingCounts(List.of(noise), List.of(signal)));
      if (fit.flaw().isEmpty()) {
        fitted++;
        assertThat(fit.distance().value()).isFinite();
        assertThat(fit.distance().standardError()).isFinite().isPositive();
        assertThat(fit.slope().value()).isPositive();
        assertThat(fit.g2()).isFinite();
      }
    }
    assertThat(fitted).isBetween(100, 499);
  }

  @Test
  void theAreaOfTheRocIsTheProbabilityThatAPresentObjectIsRatedHigher() {
    EmpiricalRoc roc = EmpiricalRoc.of(new RatingCounts(List.of(2, 1, 1), List.of(1, 1, 2)));
    // of 16 pairs 8.5 and ties: 2*(1+2) + 1*2 = 8 higher, 2*1 + 1*1 + 1*2 = 5 alike
    assertThat(roc.area()).isCloseTo((8 + 2.5) / 16, within(1e-12));
    assertThat(roc.points())
        .containsExactly(
            new EmpiricalRoc.Point(0, 0),
            new EmpiricalRoc.Point(0.25, 0.5),
            new EmpiricalRoc.Point(0.5, 0.75),
            new EmpiricalRoc.Point(1, 1));
  }

  /** Snodgrass and Corwin's formulas by hand. */
  @Test
  void aPrimeAndBDoublePrimeOfOneRate() {
    DetectionIndices found =
        DetectionIndices.of(new ResponseCounts(8, 2, 4, 6), ExtremeRateCorrection.LOG_LINEAR);
    assertThat(found.aPrime()).isCloseTo(0.5 + 0.4 * 1.4 / (4 * 0.8 * 0.6), within(1e-12));
    assertThat(found.bDoublePrime()).isCloseTo((0.16 - 0.24) / (0.16 + 0.24), within(1e-12));
    DetectionIndices below =
        DetectionIndices.of(new ResponseCounts(4, 6, 8, 2), ExtremeRateCorrection.LOG_LINEAR);
    assertThat(below.aPrime()).isCloseTo(1 - found.aPrime(), within(1e-12));
    assertThat(below.bDoublePrime()).isCloseTo((0.16 - 0.24) / (0.16 + 0.24), within(1e-12));
    DetectionIndices perfect =
        DetectionIndices.of(new ResponseCounts(10, 0, 0, 10), ExtremeRateCorrection.NONE);
    assertThat(perfect.aPrime()).isEqualTo(1);
    assertThat(perfect.bDoublePrime()).isNaN();
    assertThat(
            DetectionIndices.of(new ResponseCounts(0, 9, 0, 5), ExtremeRateCorrection.NONE)
                .aPrime())
        .isEqualTo(0.5);
    assertThat(
            DetectionIndices.of(new ResponseCounts(0, 0, 3, 5), ExtremeRateCorrection.NONE)
                .aPrime())
        .isNaN();
  }

  private static Response answer(boolean present, boolean yes, int confidence) {
    return new Response(
        "p",
        "high",
        "kitchen",
        "cup",
        "consistent",
        present,
        yes,
        confidence,
        SourceLocation.of("r"));
  }
}
