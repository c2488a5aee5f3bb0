package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.ShowsWindows;

/** Studies whose trials and areas set qualities apart from the condition. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class TrialQualitiesTest extends CommandTestCase {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir Path folder;
  private Path study = Path.of("");

  @BeforeEach
  void scene() throws IOException {
    study = folder.resolve("study.json");
    Files.writeString(
        folder.resolve("room.x3d"),
        """
        <X3D version='4.0' profile='Full'><Scene>
        <Viewpoint DEF='Door'/>
        <ProximitySensor DEF='Hall' size='9 9 9'><MetadataSet containerField='metadata'>
          <MetadataString name='enterTimeSchema' value='"hall"'/></MetadataSet></ProximitySensor>
        <Switch DEF='Lamp' whichChoice='0'><Shape><Cone/></Shape>
          <MetadataSet containerField='metadata'>
          <MetadataSet name='fieldQualities' containerField='metadata'>
          <MetadataSet><MetadataString name='quality' value='"light"'/>
            <MetadataString name='field' value='"Sun.on"'/>
            <MetadataSet><MetadataString name='value' value='"true"'/></MetadataSet>
            <MetadataSet><MetadataString name='schemaBelonginess' value='"hall"'/>
              <MetadataString name='value' value='"false"'/></MetadataSet>
          </MetadataSet></MetadataSet></MetadataSet></Switch>
        <DirectionalLight DEF='Sun'/>
        </Scene></X3D>
        """);
  }

  private List<JsonNode> events(String kind) throws IOException {
    List<JsonNode> found = new ArrayList<>();
    for (String line : Files.readAllLines(folder.resolve("sub-001/ses-01/events.jsonl"))) {
      JsonNode event = JSON.readTree(line);
      if (event.path("event").asText().equals(kind)) {
        found.add(event);
      }
    }
    return found;
  }

  private void run(String text) throws IOException {
    Files.writeString(study, text);
    assertThat(
            execute(
                "experiment",
                "run",
                study.toString(),
                "--unattended",
                "--trust",
                "--participant",
                "001"))
        .as(messages())
        .isZero();
  }

  /** Returns what each finished trial records: its level, its qualities and the lamp's level. */
  private TreeSet<String> shown() throws IOException {
    TreeSet<String> shown = new TreeSet<>();
    for (JsonNode end : events("step-finished")) {
      String step = end.path("step").asText();
      for (JsonNode event : events("scene")) {
        JsonNode what = event.path("what");
        if (event.path("step").asText().equals(step) && what.path("event").asText().equals("start")) {
          shown.add(end.path("qualities") + " " + what.at("/fields/Lamp/Sun.on"));
        }
      }
    }
    return shown;
  }

  @Test
  void aLevelOfAFactorSetsAQualityApartFromTheCondition() throws IOException {
    run(
        """
        {"name": "Lamps", "scene": "room.x3d", "participants": 1,
         "qualities": {"textures": "high"},
         "factors": [{"name": "lamp", "varies": "within", "levels": [
           {"name": "bright", "condition": "high"},
           {"name": "dark", "condition": "high", "qualities": {"light": "low"}}]}],
         "blocks": [{"name": "main", "viewpoint": "Door",
           "trial": [{"show": "exposure", "seconds": 0.2}]}]}
        """);
    assertThat(shown())
        .containsExactly("{\"light\":\"low\",\"textures\":\"high\"} 1", "{\"textures\":\"high\"} 0");
  }

  @Test
  void theAreasOfAStudyHaveItsQualities() throws IOException {
    run(
        """
        {"name": "Lamps", "scene": "room.x3d", "participants": 1, "conditions": ["high"],
         "qualities": {"light": "low"}, "fade": 0,
         "areas": [{"name": "Hall", "viewpoint": "Door", "seconds": 0.2}]}
        """);
    assertThat(shown()).contains("{\"light\":\"low\"} 1");
  }
}
