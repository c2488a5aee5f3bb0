package org.selectiverenderer.browser.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ViewExtentTest {
  @Test
  void aPictureWiderThanItShowsMoreToBothSides() {
    assertThat(new ViewExtent(0, -1, 2, 1).filling(2)).isEqualTo(new ViewExtent(-1, -1, 3, 1));
  }

  @Test
  void aPictureNarrowerThanItShowsMoreAboveAndBelow() {
    assertThat(new ViewExtent(0, -1, 2, 1).filling(0.5)).isEqualTo(new ViewExtent(0, -2, 2, 2));
  }

  @Test
  void aFieldThatSpansNothingIsTakenAsTheDefault() {
    assertThat(ViewExtent.of(new float[] {1, 2, 3})).isEqualTo(ViewExtent.DEFAULT);
    assertThat(ViewExtent.of(new float[] {1, 0, 1, 2})).isEqualTo(ViewExtent.DEFAULT);
    assertThat(ViewExtent.of(new float[] {0, 0, 1, 2})).isEqualTo(new ViewExtent(0, 0, 1, 2));
  }
}
