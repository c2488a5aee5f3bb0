package org.selectiverenderer.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.bench.measure.ConditionComparison.Runs;

class ConditionComparisonTest {
  private final ObjectMapper json = new ObjectMapper();

  private List<JsonNode> usual(double... fps) {
    return Arrays.stream(fps)
        .mapToObj(value -> (JsonNode) json.createObjectNode().put("fps", value))
        .toList();
  }

  private List<JsonNode> small(double... milliseconds) {
    return Arrays.stream(milliseconds)
        .mapToObj(
            value -> {
              ObjectNode run = json.createObjectNode();
              run.putObject("frame_ms").put("processor", value);
              return (JsonNode) run;
            })
        .toList();
  }

  @Test
  void theRatioIsTheMiddleOneOfNeighbouringRunsAndNotThatOfTheMedians() {
    ObjectNode room = json.createObjectNode();

    ConditionComparison.put(
        room,
        Map.of(
            "high",
            new Runs(usual(10, 40, 20), small(8, 12, 10)),
            "high-low",
            new Runs(usual(1, 1, 1), small(1, 1, 1)),
            "selective",
            new Runs(usual(20, 60, 80), small(2, 6, 1))));

    assertThat(room.get("selective_to_high").asDouble()).isEqualTo(2);
    assertThat(room.at("/high/fps").asDouble()).isEqualTo(20);
    assertThat(room.at("/selective/fps").asDouble()).isEqualTo(60);
  }

  @Test
  void theTimeOfVerticesIsTheProcessorTimeOfAFrameInTheSmallPicture() {
    ObjectNode room = json.createObjectNode();

    ConditionComparison.put(
        room,
        Map.of("high", new Runs(usual(10), small(8)), "selective", new Runs(usual(30), small(2))));

    assertThat(room.at("/high/vertex_ms").asDouble()).isEqualTo(8);
    assertThat(room.at("/selective/vertex_ms").asDouble()).isEqualTo(2);
    assertThat(room.get("vertex_to_high").asDouble()).isEqualTo(0.25);
  }
}
