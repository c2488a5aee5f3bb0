package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RoomMeasurementTest {
  private final ObjectMapper json = new ObjectMapper();

  private List<JsonNode> runs(double... fps) {
    return Arrays.stream(fps)
        .mapToObj(value -> (JsonNode) json.createObjectNode().put("fps", value))
        .toList();
  }

  @Test
  void theRatioIsTheMiddleOneOfNeighbouringRunsAndNotThatOfTheMedians() {
    ObjectNode room = json.createObjectNode();

    RoomMeasurement.put(
        room,
        Map.of("high", runs(10, 40, 20), "high-low", runs(1, 1, 1), "selective", runs(20, 60, 80)));

    assertThat(room.get("selective_to_high").asDouble()).isEqualTo(2);
    assertThat(room.at("/high/fps").asDouble()).isEqualTo(20);
    assertThat(room.at("/selective/fps").asDouble()).isEqualTo(60);
  }

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
