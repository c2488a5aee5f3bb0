package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RoomMeasurementTest {
  @Test
  void theTurnGoesAllRoundOnOneSpot() {
    assertThat(RoomMeasurement.turn(1.5).lines())
        .hasSize(6)
        .startsWith("t,x,y,z,yaw,pitch,roll")
        .last()
        .asString()
        .startsWith("2.0,1.500,")
        .endsWith(",0,360,-8,0");
  }

  @Test
  void theLargeModelHasAMillionTrianglesAndNoBorder() {
    int[] indices = SimplificationMeasurement.torus().indices();
    long crossed = 0;
    for (int i = 0; i < indices.length; i += 3) {
      crossed += edge(indices[i], indices[i + 1]);
      crossed += edge(indices[i + 1], indices[i + 2]);
      crossed += edge(indices[i + 2], indices[i]);
    }

    assertThat(indices).hasSize(3 * 1_001_112);
    assertThat(crossed).as("every edge is passed once each way").isZero();
  }

  /** A number for an edge, negative for the same edge backwards. */
  private static long edge(int from, int to) {
    long hash = (Math.min(from, to) * 1_000_003L + Math.max(from, to)) * 2_654_435_761L;
    return from < to ? hash : -hash;
  }
}
