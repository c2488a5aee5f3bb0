package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.testing.ShowsWindows;

/** A study of blocks and trials from its plan to the analysis, with simulated participants. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class TrialSessionTest extends CommandTestCase {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir Path folder;
  private Path study = Path.of("");

  @BeforeEach
  void changeBlindness() throws IOException {
    Files.writeString(
        folder.resolve("room.x3d"),
        """
        <X3D version='4.0' profile='Immersive'><Scene>
        <Viewpoint DEF='Door'/>
        <Switch DEF='Vase' whichChoice='0'><Shape><Sphere radius='0.1'/></Shape><Shape><Box/></Shape></Switch>
        <Switch DEF='Lamp' whichChoice='0'><Shape><Cone/></Shape><Shape><Cylinder/></Shape></Switch>
        <MetadataString DEF='SelectiveRendererEvents' name='events'/>
        <TimeSensor DEF='Clock' loop='true' cycleInterval='0.2'/>
        <Script DEF='Marker'><field accessType='inputOnly' type='SFTime' name='tick'/>
        <field accessType='outputOnly' type='MFString' name='marked'/>
        <![CDATA[ecmascript: function tick(value) { marked = new MFString('ticked', 'end-trial'); }]]></Script>
        <ROUTE fromNode='Clock' fromField='cycleTime' toNode='Marker' toField='tick'/>
        <ROUTE fromNode='Marker' fromField='marked' toNode='SelectiveRendererEvents' toField='value'/>
        </Scene></X3D>
        """);
    Files.writeString(folder.resolve("list.csv"), "object,answer\nVase,f\nLamp,j\n");
    Files.writeString(
        folder.resolve("sure.json"),
        """
        {"name": "sure", "pages": [{"questions": [
          {"id": "sure", "kind": "scale", "text": "How sure?", "from": 1, "to": 5}]}]}
        """);
    study = folder.resolve("study.json");
    Files.writeString(
        study,
        """
        {"name": "Changes", "scene": "room.x3d", "participants": 4, "seed": 2,
         "factors": [{"name": "quality", "varies": "within", "levels": [
           {"name": "full", "condition": "high"},
           {"name": "low", "condition": "high", "choices": {"Lamp": 1}}]}],
         "blocks": [
          {"name": "training", "factors": [], "practice": {"correct": 1, "rounds": 1},
           "trial": [{"show": "instruction", "text": "Look"}, {"show": "fixation", "seconds": 0.1},
             {"show": "exposure", "until": "scene"},
             {"show": "feedback", "correct": "Right", "wrong": "Wrong", "seconds": 0.1}]},
          {"name": "main", "stimuli": "list.csv", "order": "random", "rest": 2, "viewpoint": "Door",
           "trial": [{"show": "repeat", "most": 5, "phases": [
             {"show": "exposure", "seconds": 0.1, "choices": {"{object}": 0}, "keys": ["f", "j"], "correct": "{answer}"},
             {"show": "blank", "seconds": 0.05, "keys": ["f", "j"], "correct": "{answer}"},
             {"show": "exposure", "seconds": 0.1, "choices": {"{object}": 1}, "keys": ["f", "j"], "correct": "{answer}"}]},
             {"show": "questions", "questionnaire": "sure"}]}],
         "questionnaires": [{"file": "sure.json", "when": "in-trials"}]}
        """);
  }

  private int run(String... more) {
    List<String> command =
        new ArrayList<>(List.of("experiment", "run", study.toString(), "--unattended", "--trust"));
    command.addAll(List.of(more));
    return execute(command.toArray(String[]::new));
  }

  private List<JsonNode> events(String participant, String kind) throws IOException {
    List<JsonNode> found = new ArrayList<>();
    for (String line :
        Files.readAllLines(folder.resolve("sub-" + participant + "/ses-01/events.jsonl"))) {
      JsonNode event = JSON.readTree(line);
      if (event.path("event").asText().equals(kind)) {
        found.add(event);
      }
    }
    return found;
  }

  @Test
  void aStudyOfTrialsIsPlannedRunCollectedAndAnalysed() throws IOException {
    assertThat(execute("experiment", "plan", study.toString())).as(messages()).isZero();
    String plan = printed();
    assertThat(plan).contains(">1     all").contains("training: trial").contains("line 2");
    for (String participant : List.of("001", "002", "003")) {
      assertThat(run("--participant", participant)).as(messages()).isZero();
    }
    assertThat(events("001", "trial-order")).hasSize(2);
    assertThat(events("001", "step-finished"))
        .extracting(event -> event.path("step").asText())
        .containsExactly(
            "form",
            "training-001",
            "training",
            "main-001",
            "main-002",
            "main-003",
            "main-004",
            "main");
    assertThat(events("001", "scene-event"))
        .isNotEmpty()
        .allSatisfy(event -> assertThat(event.path("text").asText()).isEqualTo("end-trial"));
    JsonNode trial = events("001", "step-finished").get(3);
    assertThat(trial.path("phases").get(0).path("phase").asText()).isEqualTo("exposure");
    assertThat(trial.path("phases").get(0).path("seconds").asDouble()).isBetween(0.05, 1.0);
    assertThat(trial.path("response").asText()).isIn("f", "j");
    Path trials = folder.resolve("trials.csv");
    assertThat(execute("experiment", "collect", study.toString(), "--trials", trials.toString()))
        .as(messages())
        .isZero();
    List<String> rows = Files.readAllLines(trials);
    assertThat(rows.get(0))
        .isEqualTo(
            "participant,session,group,block,trial,round,quality,object,answer,response,ms,correct,"
                + "sure.sure");
    assertThat(rows).hasSize(1 + 3 * 4);
    assertThat(rows.get(1)).startsWith("001,1,all,main,1,1,").matches(".*,[1-5]");
    // What participants saw stays, whatever becomes of the list.
    Files.writeString(folder.resolve("list.csv"), "object,answer\nLamp,j\nLamp,f\nVase,f\n");
    Path again = folder.resolve("again.csv");
    assertThat(execute("experiment", "collect", study.toString(), "--trials", again.toString()))
        .as(messages())
        .isZero();
    assertThat(again).hasSameTextualContentAs(trials);
    assertThat(
            execute(
                "experiment",
                "anova",
                trials.toString(),
                "--dv",
                "ms",
                "--subject",
                "participant",
                "--within",
                "quality",
                "--mean",
                "--format",
                "json"))
        .as(messages())
        .isZero();
    assertThat(printed()).contains("quality");
  }

  @Test
  void aSessionContinuesInTheMiddleOfABlockInTheRecordedOrder() throws IOException {
    assertThat(run("--participant", "001")).as(messages()).isZero();
    Path journal = folder.resolve("sub-001/ses-01/events.jsonl");
    List<String> lines = Files.readAllLines(journal);
    int cut = 0;
    while (!lines.get(cut).contains("\"step-finished\",\"step\":\"main-002\"")) {
      cut++;
    }
    List<JsonNode> before = events("001", "step-finished");
    Files.writeString(journal, String.join("\n", lines.subList(0, cut + 1)) + "\n");
    Files.delete(folder.resolve("sub-001/ses-01/trials.csv"));
    for (String name : List.of("main-003_run-01", "main-004_run-01")) {
      for (String end : List.of(".csv", ".json")) {
        Files.delete(folder.resolve("sub-001/ses-01/head/" + name + end));
      }
    }
    assertThat(run("--participant", "001", "--resume")).as(messages()).isZero();
    List<JsonNode> after = events("001", "step-finished");
    assertThat(after)
        .extracting(event -> event.path("step").asText() + event.path("line").asText())
        .containsExactlyElementsOf(
            before.stream()
                .map(event -> event.path("step").asText() + event.path("line").asText())
                .toList());
  }
}
