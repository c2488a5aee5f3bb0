package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaActivation.Change;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;

/**
 * Holds the controller to the table of cases that the exported Script is held to by {@code
 * web/test/controller.test.ts}.
 */
class ActivationCasesTest {
  private static JsonNode table() throws IOException {
    try (InputStream in = ActivationCasesTest.class.getResourceAsStream("activation-cases.json")) {
      return new ObjectMapper().readTree(in);
    }
  }

  @TestFactory
  Stream<DynamicTest> cases() throws IOException {
    List<JsonNode> cases = new ArrayList<>();
    table().get("cases").forEach(cases::add);
    assertThat(cases).isNotEmpty();
    return cases.stream().map(c -> DynamicTest.dynamicTest(c.get("name").asText(), () -> run(c)));
  }

  private static void run(JsonNode given) {
    SchemaActivation<String, String> activation = new SchemaActivation<>();
    given
        .get("areas")
        .properties()
        .forEach(
            area ->
                activation.putArea(
                    area.getKey(),
                    new SensorSchemas(
                        strings(area.getValue().get("enter")),
                        strings(area.getValue().get("exit")))));
    given
        .get("objects")
        .properties()
        .forEach(
            object ->
                activation.putSwitch(
                    object.getKey(),
                    schemas(object.getValue().get("choices")),
                    object.getValue().get("shown").asInt()));
    for (JsonNode step : given.get("steps")) {
      List<Change<String>> changes =
          step.has("enter")
              ? activation.enter(step.get("enter").asText())
              : activation.exit(step.get("exit").asText());
      Map<String, Integer> wanted = new LinkedHashMap<>();
      step.get("changes").properties().forEach(c -> wanted.put(c.getKey(), c.getValue().asInt()));
      Map<String, Integer> found = new LinkedHashMap<>();
      changes.forEach(change -> found.put(change.switchKey(), change.to()));
      assertThat(found).as(step.toString()).isEqualTo(wanted);
    }
  }

  @TestFactory
  Stream<DynamicTest> draws() throws IOException {
    List<JsonNode> draws = new ArrayList<>();
    table().get("draws").forEach(draws::add);
    assertThat(draws).isNotEmpty();
    return draws.stream().map(d -> DynamicTest.dynamicTest(d.toString(), () -> draw(d)));
  }

  private static void draw(JsonNode given) {
    SwitchSchemas versions = new SwitchSchemas(List.of(version(0, "S"), version(1, "T")));
    Map<Integer, SwitchSchemas> objects = new LinkedHashMap<>();
    for (int i = 0; i < given.get("objects").asInt(); i++) {
      objects.put(i, versions);
    }
    Map<Integer, Integer> choices =
        Condition.RANDOM.initialChoices(objects, Set.of(), given.get("seed").asLong());
    List<Integer> few = new ArrayList<>();
    given.get("few").forEach(object -> few.add(object.asInt()));
    assertThat(objects.keySet().stream().filter(i -> choices.get(i) == versions.leastDetailed()))
        .containsExactlyElementsOf(few);
  }

  private static SwitchSchemas schemas(JsonNode choices) {
    List<List<String>> byChoice = new ArrayList<>();
    choices
        .properties()
        .forEach(
            choice -> {
              while (byChoice.size() <= choice.getValue().asInt()) {
                byChoice.add(new ArrayList<>());
              }
              byChoice.get(choice.getValue().asInt()).add(choice.getKey());
            });
    return new SwitchSchemas(
        IntStream.range(0, byChoice.size())
            .mapToObj(i -> version(i, byChoice.get(i).toArray(String[]::new)))
            .toList());
  }

  private static VersionMetadata version(int choice, String... schemas) {
    return new VersionMetadata(choice, Optional.empty(), Optional.empty(), List.of(schemas));
  }

  private static List<String> strings(JsonNode array) {
    List<String> values = new ArrayList<>();
    array.forEach(value -> values.add(value.asText()));
    return values;
  }
}
