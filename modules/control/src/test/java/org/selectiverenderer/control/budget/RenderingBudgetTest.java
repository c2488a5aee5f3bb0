package org.selectiverenderer.control.budget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Budgets are read as on the command line; losses and weights are those of the formulas. */
class RenderingBudgetTest {
  @ParameterizedTest
  @ValueSource(strings = {"triangles:1", "triangles:120000", "ms:16", "ms:0.5", "ms:16.6"})
  void aBudgetIsReadAndWrittenAlike(String text) {
    assertThat(RenderingBudget.of(text).orElseThrow()).hasToString(text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "120000",
        "triangles:",
        "triangles:0",
        "triangles:-3",
        "triangles:1.5",
        "ms:0",
        "ms:-1",
        "ms:1e3",
        "ms:NaN",
        "ms: 5",
        "Triangles:5",
        "triangles:9999999999999"
      })
  void anythingElseIsNone(String text) {
    assertThat(RenderingBudget.of(text)).isEmpty();
  }

  @Test
  void aHundredTrianglesLoseAHundredthAndNoneLosesAll() {
    assertThat(VersionLoss.ofTriangles(99)).isEqualTo(0.01);
    assertThat(VersionLoss.ofTriangles(0)).isEqualTo(1);
  }

  @Test
  void sizeFallsWithTheSquareOfTheDistance() {
    assertThat(VersionLoss.sizeInView(1, 10)).isCloseTo(0.0025, within(1e-12));
    assertThat(VersionLoss.sizeInView(1, 20)).isCloseTo(0.0025 / 4, within(1e-12));
    assertThat(VersionLoss.sizeInView(1, 0)).isEqualTo(0.25);
    assertThat(VersionLoss.sizeInView(0, 3)).isZero();
  }

  @Test
  void whatIsExpectedOutOfViewOrAwayFromTheGazeCountsLess() {
    assertThat(VersionLoss.weightOfConsistency(0)).isEqualTo(1);
    assertThat(VersionLoss.weightOfConsistency(0.5)).isCloseTo(0.55, within(1e-12));
    assertThat(VersionLoss.weightOfConsistency(1)).isCloseTo(0.1, within(1e-12));
    assertThat(VersionLoss.weightOfView(true)).isEqualTo(1);
    assertThat(VersionLoss.weightOfView(false)).isEqualTo(0.25);
    assertThat(VersionLoss.weightOfGaze(0)).isEqualTo(1);
    // At 20 degrees a cycle is 1/48 + 0.44 degrees.
    assertThat(VersionLoss.weightOfGaze(20)).isCloseTo(1 / (1 + 48 * 0.44), within(1e-12));
  }
}
