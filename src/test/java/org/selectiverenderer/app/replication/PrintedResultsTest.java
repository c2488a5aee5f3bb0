package org.selectiverenderer.app.replication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.statistics.detection.ConfidenceThreshold;
import org.selectiverenderer.statistics.detection.DetectionMeasure;
import org.selectiverenderer.statistics.simulation.ScoreTarget;

/** What is computed from print alone. */
class PrintedResultsTest {
  @Test
  void theKitchensAnalysesFollowFromItsMeans() {
    assertThat(KitchenRecomputation.rows()).hasSize(44).allMatch(KitchenRecomputation.Row::same);
    assertThat(KitchenRecomputation.meanSquareOfGroups()).isCloseTo(0.560, within(0.0005));
  }

  @Test
  void fourTotalsAreMisprinted() {
    assertThat(ReplicationFindings.misprintedTotals())
        .extracting(ReplicationFindings.TotalRow::printed)
        .containsExactly(0.40, 0.02, 0.69, 0.30);
  }

  @Test
  void tablesPrintEveryRowOfTheThesis() {
    assertThat(ThesisTables.scores()).hasSize(36);
    assertThat(ThesisTables.scores())
        .extracting(ThesisTables.ScoreRow::table)
        .containsOnly(6, 7, 8, 9, 10, 11);
  }

  /** Three groups of 18 whose means are 0, 1 and 2 with deviations of 1: F = 18 x 1 / 1. */
  @Test
  void fOfConditionsIsThatOfMeansAndDeviations() {
    assertThat(PrintedTests.f(test("condition", 5), rows("neutral", 1, 2, 3)))
        .isCloseTo(18, within(0.3));
  }

  /** Deviations of 1 and a difference of 1: a variance of 54 / F = 2 - 2 r. */
  @Test
  void theCorrelationIsTheOneThatFImplies() {
    List<ThesisTables.ScoreRow> types =
        List.of(rows("consistent", 1, 1, 1).get(0), rows("inconsistent", 2, 2, 2).get(0));

    assertThat(PrintedTests.correlation(test("type", 54), types).orElseThrow())
        .isCloseTo(0.5, within(0.02));
    assertThat(PrintedTests.correlation(test("type", 27), types).orElseThrow())
        .isCloseTo(0, within(0.02));
  }

  @Test
  void oneTestOfTheTextDoesNotGoWithItsTable() {
    List<String> remarks =
        ThesisTables.effects().stream()
            .map(PrintedTests::remark)
            .filter(remark -> remark.contains("misprinted"))
            .toList();

    assertThat(remarks).hasSize(1).allMatch(remark -> remark.contains("0.97"));
  }

  private static ThesisTables.PrintedEffect test(String effect, double f) {
    return new ThesisTables.PrintedEffect(
        "any", ConfidenceThreshold.ALL, DetectionMeasure.D_PRIME, effect, f, 2, 51, "here");
  }

  private static List<ThesisTables.ScoreRow> rows(String type, double... means) {
    return Arrays.stream(means)
        .mapToObj(
            mean -> {
              ScoreTarget all = new ScoreTarget(mean, 1, 0, 1);
              return new ThesisTables.ScoreRow("any", type, 12, "c" + mean, List.of(all, all, all));
            })
        .toList();
  }
}
