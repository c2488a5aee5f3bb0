package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.TriggerSettings.Code;
import org.selectiverenderer.study.definition.TriggerSettings.Line;
import org.selectiverenderer.study.definition.TriggerSettings.Wire;

class TriggerSettingsReaderTest {
  @TempDir private Path folder = Path.of("");
  private final ProblemCollector problems = new ProblemCollector();

  private Optional<Study> read(String triggers) throws IOException {
    Files.writeString(
        folder.resolve("w.csv"), "word,shade,code,wrong\nsun,dim,7,7\nice,lit,8,300\n");
    Path file =
        Files.writeString(
            folder.resolve("study.json"),
            """
            {"triggers": %s,
             "name": "t", "participants": 2,
             "factors": [{"name": "shade", "varies": "within", "levels": [{"name": "dim"}, {"name": "lit"}]}],
             "blocks": [{"name": "main", "stimuli": "w.csv",
                         "trial": [{"show": "blank", "seconds": 1, "keys": ["f"]}]}]}
            """
                .formatted(triggers));
    return StudyReader.read(file, problems);
  }

  @Test
  void bytesColumnsAndWiresAreRead() throws IOException {
    Optional<Study> study =
        read(
            "{\"port\": \"COM3\", \"events\": {\"blank-began\": 4, \"response\": \"{code}\","
                + " \"step-began\": {\"byte\": 5, \"ms\": 2.5}, \"note\": {\"line\": \"dtr\"}}}");
    assertThat(problems.list()).isEmpty();
    TriggerSettings triggers = study.orElseThrow().triggers().orElseThrow();
    assertThat(triggers)
        .isEqualTo(
            new TriggerSettings(
                "COM3",
                115_200,
                Map.of(
                    "blank-began", new Code("4", 0),
                    "response", new Code("{code}", 0),
                    "step-began", new Code("5", 2.5),
                    "note", new Line(Wire.DTR, 10))));
  }

  @Test
  void theUserIsAskedForThePort() throws IOException {
    Study study = read("{\"port\": \"COM3\", \"events\": {\"response\": 1}}").orElseThrow();
    assertThat(StudyPermissions.of(study).toString())
        .contains("opens the serial port COM3 and sends signals by it");
  }

  @Test
  void aStudyWithoutTheKeyHasNoTriggers() throws IOException {
    assertThat(read("null").orElseThrow().triggers()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{\"events\": {\"response\": 1}} | \"port\"",
        "{\"port\": \"COM3\"} | \"events\" is needed",
        "{\"port\": \"COM3\", \"events\": {\"respons\": 1}} | did you mean \"response\"?",
        "{\"port\": \"COM3\", \"events\": {\"response\": 256}} | \"response\"",
        "{\"port\": \"COM3\", \"events\": {\"response\": 0}} | \"response\"",
        "{\"port\": \"COM3\", \"events\": {\"response\": \"x\"}} | a byte is a number from 1 to 255",
        "{\"port\": \"COM3\", \"events\": {\"response\": \"{cod}\"}} | {cod} is neither a factor nor",
        "{\"port\": \"COM3\", \"events\": {\"response\": \"{wrong}\"}} | line 3 of w.csv has '300'",
        "{\"port\": \"COM3\", \"events\": {\"note\": \"{code}\"}} | the event note has no stimulus",
        "{\"port\": \"COM3\", \"events\": {\"note\": {\"ms\": 3}}} | either a \"byte\" or a \"line\"",
        "{\"port\": \"COM3\", \"events\": {\"note\": {\"line\": \"cts\"}}} | 'cts' is not one of rts, dtr",
        "{\"port\": \"COM3\", \"events\": {\"note\": {\"line\": \"rts\", \"ms\": 0}}} | more than 0 ms",
        "{\"port\": \"COM3\", \"events\": {\"note\": {\"byte\": 1, \"ms\": 5000}}} | \"ms\""
      })
  void whatCannotBeIsAnErrorWithItsPlace(String triggers, String message) throws IOException {
    assertThat(read(triggers)).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .anyMatch(line -> line.contains("study.json:1:") && line.contains(message));
  }
}
