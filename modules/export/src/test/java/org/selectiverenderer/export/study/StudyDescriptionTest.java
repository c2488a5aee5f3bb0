package org.selectiverenderer.export.study;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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

  /** Returns the description without the program's own words, which have tests of their own. */
  private static String withoutWords(String text) throws IOException {
    ObjectNode json = (ObjectNode) new ObjectMapper().readTree(text);
    json.path("texts").forEach(texts -> ((ObjectNode) texts).remove("words"));
    return JsonWriter.of(json).strip();
  }
}
