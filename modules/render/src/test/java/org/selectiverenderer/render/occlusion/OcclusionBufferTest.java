package org.selectiverenderer.render.occlusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class OcclusionBufferTest {
  private static final double MARGIN = 0.1;
  private final OcclusionBuffer grid = new OcclusionBuffer();

  OcclusionBufferTest() {
    grid.clear(MARGIN, MARGIN);
  }

  private void outline(double... corners) {
    for (int i = 0; i < corners.length; i += 2) {
      int next = (i + 2) % corners.length;
      grid.edge(corners[i], corners[i + 1], corners[next], corners[next + 1]);
    }
  }

  private static ConservativeDepthBound upTo(double nearest) {
    ConservativeDepthBound side = new ConservativeDepthBound();
    side.begin(nearest);
    return side;
  }

  private int fill(double depth) {
    int covered = grid.fill(0, 0, 1 / depth);
    grid.finish();
    return covered;
  }

  @Test
  void onlyCellsThatAreCoveredWithTheirMarginCount() {
    outline(10, 10, 14, 10, 14, 14, 10, 14);
    assertThat(fill(2)).isEqualTo(4);
    assertThat(grid.hiddenFrom(11, 11)).isEqualTo(0.5f);
    assertThat(grid.hiddenFrom(10, 11)).isZero();
    assertThat(grid.hiddenFrom(13, 12)).isZero();
    assertThat(grid.hides(11, 11, 12.9, 12.9, upTo(0.4))).isTrue();
    assertThat(grid.hides(11, 11, 12.9, 12.9, upTo(0.5))).isFalse();
    assertThat(grid.hides(11, 11, 13.01, 12.9, upTo(0.4))).isFalse();
  }

  @Test
  void holesAreNotCovered() {
    outline(-5, -5, 200, -5, 200, 200, -5, 200);
    outline(60, 40, 60.001, 40, 60.001, 44, 60, 44);
    assertThat(fill(2)).isEqualTo(128 * 96 - 2 * 6);
    assertThat(grid.hides(59, 41, 60.5, 42, upTo(0.1))).isFalse();
    assertThat(grid.hides(61, 41, 62.5, 42, upTo(0.1))).isTrue();
  }

  @Test
  void theNearerOfTwoHides() {
    outline(10, 10, 30, 10, 30, 30, 10, 30);
    fill(2);
    outline(10, 10, 30, 10, 30, 30, 10, 30);
    fill(4);
    assertThat(grid.hiddenFrom(20, 20)).isEqualTo(0.5f);
  }

  @Test
  void whatIsPutTogetherFromTwoLeavesTheirSeamOpen() {
    outline(10, 10, 20.5, 10, 20.5, 30, 10, 30);
    fill(2);
    outline(20.5, 10, 30, 10, 30, 30, 20.5, 30);
    fill(2);
    assertThat(grid.hiddenFrom(19, 20)).isPositive();
    assertThat(grid.hiddenFrom(20, 20)).isZero();
    assertThat(grid.hiddenFrom(21, 20)).isPositive();
  }

  @Test
  void aCellIsHiddenFromItsFarthestPointOn() {
    outline(10, 10, 30, 10, 30, 30, 10, 30);
    grid.fill(-0.01, 0, 1);
    assertThat((double) grid.hiddenFrom(20, 20)).isBetween(0.789 - 1e-6, 0.789 + 1e-6);
  }

  @Test
  void outlinesThatReachFarOutsideCoverTheView() {
    outline(-1e6, -1e6, 1e6, -1e6, 1e6, 1e6, -1e6, 1e6);
    assertThat(fill(1)).isEqualTo(128 * 96);
    grid.clear(MARGIN, MARGIN);
    outline(-9, -9, -2, -9, -2, 200, -9, 200);
    outline(130, -9, 190, -9, 190, 200, 130, 200);
    assertThat(fill(1)).isZero();
  }

  @Test
  void whatSlopesWithAWallIsHiddenBehindIt() {
    outline(-5, -5, 200, -5, 200, 200, -5, 200);
    grid.fill(0.01, 0, 0.1);
    grid.finish();
    double[] whole = {2, 2, 100, 90};
    assertThat(hides(whole, upTo(0.5))).isFalse();
    assertThat(hides(whole, sloping(0.07))).isTrue();
    assertThat(hides(whole, sloping(0.11))).isFalse();
    ConservativeDepthBound across = upTo(0.5);
    across.face(-0.01, 0, 1.5, 0, 0);
    assertThat(hides(whole, across)).isFalse();
    // Of two faces the one farther away counts.
    ConservativeDepthBound both = sloping(0.11);
    both.face(0, 0, 0.09, 0, 0);
    assertThat(hides(whole, both)).isTrue();
  }

  private static ConservativeDepthBound sloping(double atOrigin) {
    ConservativeDepthBound side = upTo(5);
    side.face(0.01, 0, atOrigin, MARGIN, MARGIN);
    return side;
  }

  private boolean hides(double[] r, ConservativeDepthBound side) {
    return grid.hides(r[0], r[1], r[2], r[3], side);
  }

  @Test
  void aLineCoversNothing() {
    outline(10, 10, 90, 60);
    assertThat(fill(1)).isZero();
  }
}
