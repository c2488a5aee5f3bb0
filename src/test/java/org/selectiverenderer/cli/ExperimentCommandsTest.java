package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExperimentCommandsTest {
  @TempDir Path folder;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private String data = "";

  @BeforeEach
  void measurements() throws IOException {
    Path file = folder.resolve("d.csv");
    Files.writeString(
        file,
        """
        id,type,group,score
        1,c,high,1.0
        1,i,high,0.5
        2,c,high,1.2
        2,i,high,0.9
        3,c,low,0.3
        3,i,low,0.8
        4,c,low,0.1
        4,i,low,0.7
        5,c,low,0.5
        5,i,low,0.6
        """);
    data = file.toString();
  }

  @Test
  void anovaWritesTheKeysThatProgramsReadByTheColumnsNames() throws IOException {
    assertThat(anova("--within", "type", "--between", "group", "--format", "json")).isZero();
    JsonNode json = new ObjectMapper().readTree(out.toByteArray());
    assertThat(json.get("effects").findValuesAsText("effect"))
        .containsExactly("group", "type", "type x group");
    for (String key : List.of("ss", "df1", "df2", "ms", "F", "p", "partial_eta2")) {
      assertThat(json.get("effects").get(0).get(key).isNumber()).as(key).isTrue();
    }
    assertThat(json.get("descriptives")).hasSize(4);
    assertThat(json.get("descriptives").get(0).get("within").asText()).isEqualTo("c");
    assertThat(json.get("descriptives").get(0).get("between").asText()).isEqualTo("high");
    assertThat(json.get("descriptives").get(0).get("mean").asDouble()).isEqualTo(1.1);
    assertThat(json.get("descriptives").get(0).get("n").asInt()).isEqualTo(2);
    assertThat(text(err)).isEmpty();
  }

  @Test
  void anovaOfOneFactorIsOneWayOrRepeatedMeasures() {
    assertThat(anova("--within", "type")).isZero();
    assertThat(text(out)).contains("type", "Pillai's trace").doesNotContain("type x group");
  }

  @Test
  void anovaOfABadTableIsStatusOneAndNamesThePlace() throws IOException {
    Files.writeString(Path.of(data), Files.readString(Path.of(data)).replace("0.7", "\"0,7\""));
    assertThat(anova("--within", "type", "--between", "group")).isEqualTo(1);
    assertThat(text(err)).contains("d.csv:9:9: participant 4: '0,7' is no number").hasLineCount(1);
    assertThat(text(out)).contains("Data that are missing or left out");
  }

  @Test
  void anovaWithoutEnoughParticipantsIsStatusOneAndNoReport() throws IOException {
    Files.writeString(Path.of(data), "id,type,group,score\n1,c,high,1\n2,c,low,2\n");
    assertThat(anova("--between", "group")).isEqualTo(1);
    assertThat(text(err)).contains("no degrees of freedom for the error; nothing is analysed");
    assertThat(text(out)).isEmpty();
  }

  @Test
  void wrongUsageIsStatusTwo() {
    assertThat(anova()).isEqualTo(2);
    assertThat(text(err)).contains("--within, --between or both");
    assertThat(anova("--within", "type", "--bounds", "-1")).isEqualTo(2);
    assertThat(anova("--within", "type", "--between", "type")).isEqualTo(2);
    assertThat(anova("--within", "type", "--output", folder.resolve("no/x").toString()))
        .isEqualTo(2);
    assertThat(execute("experiment")).isEqualTo(2);
    assertThat(execute("experiment", "simulate", "--d-prime", "1,2")).isEqualTo(2);
    assertThat(execute("experiment", "simulate", "--power", "--area", "attic")).isEqualTo(2);
    assertThat(text(err)).doesNotContain("\tat ");
  }

  @Test
  void aSimulatedStudyGoesThroughTheWholeAnalysis() throws IOException {
    Path answers = folder.resolve("r.csv");
    assertThat(
            execute(
                "experiment",
                "simulate",
                "--participants",
                "12",
                "--d-prime",
                "0.8,1.1,1.4",
                "--output",
                answers.toString()))
        .isZero();
    for (String format : List.of("text", "json", "html", "tidy", "wide")) {
      Path report = folder.resolve("report." + format);
      assertThat(
              execute(
                  "experiment",
                  "analyse",
                  answers.toString(),
                  "--format",
                  format,
                  "--output",
                  report.toString()))
          .isZero();
      assertThat(report).isNotEmptyFile();
    }
    JsonNode json = new ObjectMapper().readTree(folder.resolve("report.json").toFile());
    assertThat(json.get("analyses")).hasSize(6 * 3 * 3);
    assertThat(json.get("scores")).hasSize(12 * 9 * 3);
    assertThat(text(err)).isEmpty();
  }

  @Test
  void powerIsPrintedAndProgressGoesToTheErrorStream() {
    assertThat(
            execute("experiment", "simulate", "--power", "--participants", "12", "--studies", "20"))
        .isZero();
    assertThat(text(out)).contains("20 simulated studies of 12 participants", "condition");
    assertThat(text(err)).contains("simulate: 12 participants: 20 of 20 studies");
  }

  private int anova(String... options) {
    List<String> args =
        new ArrayList<>(List.of("experiment", "anova", data, "--dv", "score", "--subject", "id"));
    args.addAll(List.of(options));
    return execute(args.toArray(String[]::new));
  }

  private int execute(String... args) {
    out.reset();
    return Main.execute(
        args,
        new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8));
  }

  private static String text(ByteArrayOutputStream stream) {
    return stream.toString(StandardCharsets.UTF_8);
  }
}
