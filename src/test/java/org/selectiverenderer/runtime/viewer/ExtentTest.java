package org.selectiverenderer.runtime.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ExtentTest {
  @Test
  void aPictureWiderThanItShowsMoreToBothSides() {
    assertThat(new Extent(0, -1, 2, 1).filling(2)).isEqualTo(new Extent(-1, -1, 3, 1));
  }

  @Test
  void aPictureNarrowerThanItShowsMoreAboveAndBelow() {
    assertThat(new Extent(0, -1, 2, 1).filling(0.5)).isEqualTo(new Extent(0, -2, 2, 2));
  }

  @Test
  void aFieldThatSpansNothingIsTakenAsTheDefault() {
    assertThat(Extent.of(new float[] {1, 2, 3})).isEqualTo(Extent.DEFAULT);
    assertThat(Extent.of(new float[] {1, 0, 1, 2})).isEqualTo(Extent.DEFAULT);
    assertThat(Extent.of(new float[] {0, 0, 1, 2})).isEqualTo(new Extent(0, 0, 1, 2));
  }
}
