package org.selectiverenderer.export.study;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.PlannedSession;

class StudyDescriptionTest {
  private static final Path GOLDEN =
      Path.of(
          "modules/export/src/test/resources/org/selectiverenderer/export/study/study-web.json");

  @TempDir Path folder;

  /** The golden file holds all that the page reads; -Dreports.update=true writes it anew. */
  @Test
  void aSmallStudyIsDescribedAsThePageReadsIt() throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    String text =
        new StudyDescription(
                fixture.read(
                    StudyFixture.text(
                        "  \"fade\": 0.5,\n  \"stay\": \"turn\",\n  \"quality\": {\"min_fps\": 30},\n")),
                new StudyPictures())
            .text(Map.of(), Map.of());
    if (Boolean.getBoolean("reports.update")) {
      Files.writeString(GOLDEN, withoutWords(text) + "\n");
    }
    assertThat(withoutWords(text)).isEqualTo(Files.readString(GOLDEN).strip());
  }

  @Test
  void groupsOfBetweenFactorsAreThoseOfTheDesktopsPlan() throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    List<LoadedStudy> study =
        fixture.read(
            StudyFixture.text(
                    """
                      "factors": [
                        {"name": "quality", "varies": "between", "levels": [
                          {"name": "best", "condition": "high"}, {"name": "mixed", "condition": "random"}]},
                        {"name": "task", "varies": "between", "levels": [{"name": "search"}, {"name": "look"}]}],
                    """)
                .replace("  \"conditions\": [\"high\", \"selective\"],\n", ""));
    assertThat(new BrowserLimits(study.get(0), fixture.collector()).keep()).isTrue();
    JsonNode slots =
        new ObjectMapper()
            .readTree(new StudyDescription(study, new StudyPictures()).text(Map.of(), Map.of()))
            .path("slots");
    List<PlannedSession> plan = PlannedSession.all(study.get(0));
    for (int i = 0; i < plan.size(); i++) {
      assertThat(slots.get(i).path("group").asText()).isEqualTo(plan.get(i).group().name());
      assertThat(slots.get(i).path("condition").asText())
          .isEqualTo(plan.get(i).group().name().startsWith("best+") ? "high" : "random");
    }
    assertThat(plan).extracting(session -> session.group().name()).doesNotHaveDuplicates();
  }

  @Test
  void theTrialsOfAPlaceAreThoseOfTheDesktopsPlan() throws IOException {
    StudyFixture fixture = new StudyFixture(folder);
    List<LoadedStudy> study =
        fixture.read(
            StudyFixture.text(
                    """
                      "factors": [{"name": "lamp", "varies": "within", "levels": [
                        {"name": "best", "choices": {"Switch_Lamp": 0}},
                        {"name": "none", "choices": {"Switch_Lamp": -1}, "condition": "high"}]}],
                      "blocks": [{"name": "main", "order": "random", "repetitions": 3, "viewpoint": "DeskView",
                        "practice": {"correct": 1, "rounds": 2},
                        "trial": [{"show": "instruction", "text": {"en": "Look: {lamp}", "el": "Δείτε"}},
                          {"show": "exposure", "seconds": 1, "keys": ["f"], "correct": "f"}]}],
                    """)
                .replace("  \"conditions\": [\"high\", \"selective\"],\n", ""));
    JsonNode json =
        new ObjectMapper()
            .readTree(
                new StudyDescription(study, new StudyPictures())
                    .text(Map.of(), Map.of(study.get(0).study().scene().orElseThrow(), "scene")));
    assertThat(json.path("steps").path("main").path("practice").path("rounds").asInt())
        .isEqualTo(2);
    assertThat(json.path("texts").path("el").path("phases").path("main").get(0).path("text").asText())
        .isEqualTo("Δείτε");
    assertThat(json.path("trials")).hasSize(2); // each different trial once
    List<PlannedSession> plan = PlannedSession.all(study.get(0));
    var block = study.get(0).study().design().blocks().get(0);
    for (int i = 0; i < plan.size(); i++) {
      JsonNode rounds = json.path("slots").get(i).path("trials").path("main");
      assertThat(rounds).hasSize(2);
      for (int round = 1; round <= 2; round++) {
        List<String> levels = new ArrayList<>();
        for (JsonNode at : rounds.get(round - 1)) {
          JsonNode trial = json.path("trials").get(at.asInt());
          assertThat(trial.path("scene").asText()).isEqualTo("scene");
          assertThat(trial.path("condition").asText())
              .isEqualTo(
                  trial.path("levels").path("lamp").asText().equals("best") ? "selective" : "high");
          levels.add(trial.path("levels").path("lamp").asText());
        }
        assertThat(levels)
            .containsExactlyElementsOf(
                plan.get(i).trials(study.get(0).study(), block, round).stream()
                    .map(trial -> trial.levels().get("lamp"))
                    .toList());
      }
    }
  }

  /** Returns the description without the program's own words, which have tests of their own. */
  private static String withoutWords(String text) throws IOException {
    ObjectNode json = (ObjectNode) new ObjectMapper().readTree(text);
    json.path("texts").forEach(texts -> ((ObjectNode) texts).remove("words"));
    return JsonWriter.of(json).strip();
  }
}
