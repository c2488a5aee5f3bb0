package org.selectiverenderer.cli.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.formats.json.JsonTree;

/** A session's head log is shown with the changes of versions that its journal tells. */
class ExperimentViewTest extends CommandTestCase {
  private static final String LOG =
      """
      t,x,y,z,yaw,pitch,roll,motion,object,distance,version,cone,schemas,frame_ms
      0,0,1.6,0,90,0,0,moved,Coat,2.5,1,Coat,,16
      1,0,1.6,0,90,0,0,moved,,,,,,16
      """;

  private static final String DESCRIPTION =
      """
      {"started": "2026-03-01T10:00:12+02:00", "scene": "hall.x3d", "condition": "selective",
       "tracker": "none", "metres_per_unit": 1,
       "field_of_view": {"half_tangent_x": 0.5, "half_tangent_y": 0.4},
       "map": {"areas": [], "rooms": [], "objects": []}}
      """;

  private static final String JOURNAL =
      event("session-began", "\"participant\":\"001\",\"session\":1")
          + event("step-began", "\"step\":\"hall\",\"run\":1,\"head_log\":\"hall_run-01\"")
          + change("0.5", "Coat", "true", 1204)
          + event("resumed", "\"step\":\"hall\"")
          + event("step-began", "\"step\":\"hall\",\"run\":2,\"head_log\":\"hall_run-02\"")
          + change("0.2", "Coat", "false", 0)
          + change("0.7", "Lamp", "true", 77)
          + event("step-finished", "\"step\":\"hall\"");

  @TempDir Path folder;
  private Path logs = Path.of("");

  private static String event(String name, String members) {
    return "{\"time\":\"2026-03-01T10:00:00.000Z\",\"event\":\"%s\",%s}\n".formatted(name, members);
  }

  private static String change(String t, String object, String visible, int pixels) {
    return event(
        "scene",
        ("\"step\":\"hall\",\"what\":{\"t\":%s,\"event\":\"switch\",\"switch\":\"%s\",\"from\":1,"
                + "\"to\":0,\"schema\":\"S\",\"visible\":%s,\"pixels\":%d,\"turning\":1.0}")
            .formatted(t, object, visible, pixels));
  }

  @BeforeEach
  void session() throws IOException {
    logs = Files.createDirectories(folder.resolve("study/sub-001/ses-01/head"));
    Files.writeString(logs.resolveSibling("events.jsonl"), JOURNAL);
    for (String name : new String[] {"hall_run-01", "hall_run-02"}) {
      Files.writeString(logs.resolve(name + ".csv"), LOG);
      Files.writeString(logs.resolve(name + ".json"), DESCRIPTION);
    }
  }

  private String view(String log, String... more) {
    String[] command = new String[3 + more.length];
    command[0] = "experiment";
    command[1] = "view";
    command[2] = logs.resolve(log).toString();
    System.arraycopy(more, 0, command, 3, more.length);
    assertThat(execute(command)).as(messages()).isZero();
    return printed();
  }

  @Test
  void theChangesOfTheRunInTheJournalAreCounted() {
    assertThat(view("hall_run-02.csv"))
        .endsWith(
            """

            versions                          changes  visible     pixels
            Coat                                    1        0          \s
            Lamp                                    1        1         77
            2 changes, 1 of them visible
            """);
    assertThat(view("hall_run-01.csv"))
        .contains("Coat                                    1        1       1204")
        .doesNotContain("Lamp");
  }

  @Test
  void theJsonHasThemToo() throws IOException {
    JsonNode report = JsonTree.parse(view("hall_run-02.csv", "--format", "json"));
    assertThat(report.path("switches")).hasSize(2);
    assertThat(report.path("switches").get(1).path("object").asText()).isEqualTo("Lamp");
    assertThat(report.path("switches").get(1).path("pixels").asInt()).isEqualTo(77);
  }

  @Test
  void aTimeLineThatIsNamedCountsInstead() throws IOException {
    Path timeline =
        Files.writeString(
            folder.resolve("t.jsonl"),
            "{\"t\":1,\"event\":\"switch\",\"switch\":\"Cup\",\"from\":1,\"to\":0,\"schema\":\"\","
                + "\"visible\":false,\"pixels\":0,\"turning\":0.0}\n");
    assertThat(view("hall_run-02.csv", "--timeline", timeline.toString()))
        .endsWith("1 change, 0 of them visible\n")
        .doesNotContain("Lamp");
  }

  @Test
  void aLogOfNoSessionIsShownAsItIs() throws IOException {
    Files.delete(logs.resolveSibling("events.jsonl"));
    assertThat(view("hall_run-02.csv")).contains("hall.x3d").doesNotContain("versions  ");
    Files.writeString(logs.resolveSibling("events.jsonl"), event("session-began", "\"a\":1"));
    assertThat(view("hall_run-02.csv")).contains("hall.x3d").doesNotContain("versions  ");
  }
}
