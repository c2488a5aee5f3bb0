package org.selectiverenderer.statistics.detection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.SourceLocation;

class DetectionIndicesTest {
  private static final Offset<Double> EXACT = within(1e-9);

  /** z(0.8) = 0.8416212336, z(0.4) = -0.2533471031: tables of the normal distribution. */
  @Test
  void dPrimeLogBetaAndCriterionOfRates() {
    DetectionIndices found =
        DetectionIndices.of(new ResponseCounts(8, 2, 4, 6), ExtremeRateCorrection.NONE);
    assertThat(found.hitRate()).isEqualTo(0.8);
    assertThat(found.falseAlarmRate()).isEqualTo(0.4);
    assertThat(found.dPrime()).isEqualTo(0.8416212336 + 0.2533471031, EXACT);
    assertThat(found.criterion()).isEqualTo(-(0.8416212336 - 0.2533471031) / 2, EXACT);
    assertThat(found.logBeta())
        .isEqualTo((0.2533471031 * 0.2533471031 - 0.8416212336 * 0.8416212336) / 2, EXACT);
    assertThat(found.logBeta()).isEqualTo(found.dPrime() * found.criterion(), EXACT);
  }

  @Test
  void aBiasTowardsNoIsPositive() {
    DetectionIndices shy =
        DetectionIndices.of(new ResponseCounts(5, 5, 1, 9), ExtremeRateCorrection.LOG_LINEAR);
    assertThat(shy.logBeta()).isPositive();
    assertThat(shy.criterion()).isPositive();
  }

  /** Hautus 1995: (10 + 0.5) / (10 + 1) and (0 + 0.5) / (10 + 1). */
  @Test
  void theLogLinearCorrectionAddsToAllRates() {
    DetectionIndices perfect =
        DetectionIndices.of(new ResponseCounts(10, 0, 0, 10), ExtremeRateCorrection.LOG_LINEAR);
    assertThat(perfect.hitRate()).isEqualTo(10.5 / 11, EXACT);
    assertThat(perfect.falseAlarmRate()).isEqualTo(0.5 / 11, EXACT);
    assertThat(perfect.dPrime()).isEqualTo(2 * 1.6906216295848984, EXACT);
    assertThat(
            DetectionIndices.of(new ResponseCounts(8, 2, 4, 6), ExtremeRateCorrection.LOG_LINEAR)
                .hitRate())
        .isEqualTo(8.5 / 11, EXACT);
  }

  @Test
  void halfATrialReplacesRatesOfZeroAndOneOnly() {
    DetectionIndices perfect =
        DetectionIndices.of(new ResponseCounts(10, 0, 0, 5), ExtremeRateCorrection.HALF_TRIAL);
    assertThat(perfect.hitRate()).isEqualTo(0.95, EXACT);
    assertThat(perfect.falseAlarmRate()).isEqualTo(0.1, EXACT);
    assertThat(
            DetectionIndices.of(new ResponseCounts(8, 2, 4, 6), ExtremeRateCorrection.HALF_TRIAL)
                .hitRate())
        .isEqualTo(0.8);
  }

  @Test
  void withoutCorrectionARateOfOneHasNoDPrimeAndSaysWhy() {
    DetectionIndices perfect =
        DetectionIndices.of(new ResponseCounts(10, 0, 4, 6), ExtremeRateCorrection.NONE);
    assertThat(perfect.dPrime()).isNaN();
    assertThat(perfect.flaw()).hasValueSatisfying(why -> assertThat(why).contains("infinite"));
  }

  @Test
  void noAnswerToAbsentObjectsIsNoDPrimeWhateverTheCorrection() {
    DetectionIndices found =
        DetectionIndices.of(new ResponseCounts(3, 1, 0, 0), ExtremeRateCorrection.LOG_LINEAR);
    assertThat(found.dPrime()).isNaN();
    assertThat(found.flaw()).contains("no answers to absent objects are left");
  }

  @Test
  void levelsOfConfidenceCountTheirAnswersOnly() {
    List<Response> answers = new ArrayList<>();
    answers.add(answer(true, true, 5));
    answers.add(answer(true, true, 2));
    answers.add(answer(true, false, 3));
    answers.add(answer(false, true, 4));
    answers.add(answer(false, false, 1));
    answers.add(answer(false, false, 0));
    assertThat(ResponseCounts.of(answers, ConfidenceThreshold.ALL, LowConfidencePolicy.DISCARD))
        .isEqualTo(new ResponseCounts(2, 1, 1, 2));
    assertThat(
            ResponseCounts.of(answers, ConfidenceThreshold.MODERATE, LowConfidencePolicy.DISCARD))
        .isEqualTo(new ResponseCounts(1, 1, 1, 0));
    assertThat(ResponseCounts.of(answers, ConfidenceThreshold.HIGH, LowConfidencePolicy.DISCARD))
        .isEqualTo(new ResponseCounts(1, 0, 0, 0));
    // As "no": the guess of a present object is a miss; the answer without confidence stays out.
    assertThat(ResponseCounts.of(answers, ConfidenceThreshold.MODERATE, LowConfidencePolicy.AS_NO))
        .isEqualTo(new ResponseCounts(1, 2, 1, 1));
    assertThat(ResponseCounts.of(answers, ConfidenceThreshold.HIGH, LowConfidencePolicy.AS_NO))
        .isEqualTo(new ResponseCounts(1, 2, 0, 2));
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
