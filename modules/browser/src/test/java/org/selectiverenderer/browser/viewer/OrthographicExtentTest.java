package org.selectiverenderer.browser.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OrthographicExtentTest {
  @Test
  void aPictureWiderThanItShowsMoreToBothSides() {
    assertThat(new OrthographicExtent(0, -1, 2, 1).filling(2))
        .isEqualTo(new OrthographicExtent(-1, -1, 3, 1));
  }

  @Test
  void aPictureNarrowerThanItShowsMoreAboveAndBelow() {
    assertThat(new OrthographicExtent(0, -1, 2, 1).filling(0.5))
        .isEqualTo(new OrthographicExtent(0, -2, 2, 2));
  }

  @Test
  void aFieldThatSpansNothingIsTakenAsTheDefault() {
    assertThat(OrthographicExtent.of(new float[] {1, 2, 3})).isEqualTo(OrthographicExtent.DEFAULT);
    assertThat(OrthographicExtent.of(new float[] {1, 0, 1, 2}))
        .isEqualTo(OrthographicExtent.DEFAULT);
    assertThat(OrthographicExtent.of(new float[] {0, 0, 1, 2}))
        .isEqualTo(new OrthographicExtent(0, 0, 1, 2));
  }
}
