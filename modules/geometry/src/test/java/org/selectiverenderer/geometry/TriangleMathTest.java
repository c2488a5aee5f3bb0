package org.selectiverenderer.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TriangleMathTest {
  /**
   * A square of side 2 in the plane z = 1, counter-clockwise seen from +z, and a point on a side.
   */
  private static final float[] POINTS = {0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 2, 1, 1, 0, 1};

  private final double[] normal = new double[3];

  @Test
  void theNormalIsTwiceTheAreaLongAndPointsToTheFront() {
    TriangleMath.normal(POINTS, 0, 3, 6, normal);
    assertThat(normal).containsExactly(0, 0, 4);
    assertThat(TriangleMath.normalize(normal)).isEqualTo(4);
    assertThat(normal).containsExactly(0, 0, 1);
  }

  @Test
  void newellSumsThePolygonsTriangles() {
    TriangleMath.newell(POINTS, new int[] {9, 0, 4, 1, 2, 3}, 1, 6, normal);
    assertThat(normal).containsExactly(0, 0, 8);
  }

  @Test
  void aLineHasNoAreaAndNoDirection() {
    assertThat(TriangleMath.hasArea(POINTS, 0, 12, 3, 1e-12)).isFalse();
    assertThat(TriangleMath.hasArea(POINTS, 0, 12, 6, 1e-12)).isTrue();
    TriangleMath.normal(POINTS, 0, 12, 3, normal);
    assertThat(TriangleMath.normalize(normal)).isZero();
    assertThat(normal).containsExactly(0, 0, 0);
  }

  @Test
  void turnsToTheLeftArePositive() {
    double[] xy = {0, 0, 2, 0, 2, 2};
    assertThat(TriangleMath.turn(xy, 0, 1, 2)).isEqualTo(4);
    assertThat(TriangleMath.turn(xy, 2, 1, 0)).isEqualTo(-4);
    assertThat(TriangleMath.triple(new double[] {0, 0, 1}, 2, 0, 0, 2, 2, 0)).isEqualTo(4);
  }
}
