package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;

class StudyReaderTest {
  @TempDir Path folder;
  private Path file = Path.of("");
  private String text = "";

  @BeforeEach
  void thesisStudy() throws IOException {
    file = StudyTemplate.write(folder, Path.of("scenes/apartment.x3d"));
    text = Files.readString(file);
  }

  private List<String> problems(String study) throws IOException {
    Files.writeString(file, study);
    ProblemCollector problems = new ProblemCollector();
    Optional<Study> read = StudyReader.read(file, problems);
    assertThat(read.isEmpty()).isEqualTo(problems.any());
    return problems.list().stream()
        .map(Problem::toString)
        .map(line -> line.substring(file.toString().length() + 1))
        .toList();
  }

  @Test
  void aNewStudyIsTheThesiss() throws IOException {
    Study study = StudyReader.read(file, new ProblemCollector()).orElseThrow();
    assertThat(study.design().groups())
        .containsExactly(
            StudyGroup.of(Condition.HIGH),
            StudyGroup.of(Condition.HIGH_LOW),
            StudyGroup.of(Condition.SELECTIVE));
    assertThat(study.participants()).isEqualTo(54);
    assertThat(study.areas())
        .extracting(Study.Area::name)
        .containsExactly("kitchen", "lounge", "office");
    assertThat(study.areas().stream().mapToDouble(Study.Area::seconds).sum()).isEqualTo(135);
    assertThat(study.practice()).isPresent();
    assertThat(study.questionnaires().list())
        .extracting(StudyQuestionnaires.Source::content)
        .filteredOn(StudyQuestionnaires.Content.Items.class::isInstance)
        .containsExactly(
            new StudyQuestionnaires.Content.Items(
                ItemQuestionnaireKind.RECOGNITION, folder.resolve("recognition.csv")));
  }

  @Test
  void aStudyMayLeaveOutTheSoundsOfItsScenes() throws IOException {
    assertThat(StudyReader.read(file, new ProblemCollector()).orElseThrow().mute()).isFalse();
    Files.writeString(file, text.replaceFirst("\\{", "{\"mute\": true, "));
    assertThat(StudyReader.read(file, new ProblemCollector()).orElseThrow().mute()).isTrue();
  }

  @Test
  void questionsAreAskedInsideAHeadsetOnly() throws IOException {
    String study =
        """
        {"name": "Rooms", "conditions": ["selective"], "participants": 1,
         "display": {"mode": "%s", "questions": "headset"},
         "questionnaires": [{"template": "sus"}]}
        """;
    assertThat(problems(study.formatted("window")))
        .singleElement()
        .asString()
        .contains("\"questions\" needs \"mode\": \"openxr\"");
    assertThat(problems(study.formatted("openxr"))).isEmpty();
    assertThat(
            StudyReader.read(file, new ProblemCollector()).orElseThrow().display().worn().asked())
        .isTrue();
  }

  @Test
  void thePilotStudyShowsNothingAndAsksAboutExpectancy() throws IOException {
    Study pilot =
        StudyReader.read(folder.resolve("pilot/study.json"), new ProblemCollector()).orElseThrow();
    assertThat(pilot.scene()).isEmpty();
    assertThat(pilot.areas()).isEmpty();
    assertThat(pilot.questionnaires().list())
        .extracting(StudyQuestionnaires.Source::content)
        .containsExactly(
            new StudyQuestionnaires.Content.Items(
                ItemQuestionnaireKind.EXPECTANCY, folder.resolve("pilot/expectancy.csv")));
  }

  @Test
  void aStudyIsNeverWrittenOverAnother() throws IOException {
    Files.delete(folder.resolve("recognition.csv"));
    assertThatThrownBy(() -> StudyTemplate.write(folder, Path.of("scenes/apartment.x3d")))
        .hasMessageContaining("exists already; nothing was written");
    assertThat(folder.resolve("recognition.csv")).doesNotExist();
  }

  @Test
  void anUnknownKeyIsAnErrorAtItsPlace() throws IOException {
    assertThat(problems("{\n  // a comment\n  \"sceen\": 1, " + text.strip().substring(1)))
        .singleElement()
        .asString()
        .isEqualTo("3:3: a study has no \"sceen\"; did you mean \"scene\"? The study is not used");
  }

  @Test
  void anUnknownKeyOfAnAreaIsFoundToo() throws IOException {
    assertThat(
            problems(text.replace("\"KitchenMiddle\", \"seconds\"", "\"KitchenMiddle\", \"secs\"")))
        .hasSize(2)
        .anyMatch(line -> line.contains("an area needs \"seconds\""))
        .anyMatch(
            line ->
                line.contains(
                    "an area has no \"secs\" (known keys: name, seconds, stay, viewpoint, within)"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "54, | 2, | 2 participants are fewer than the 3 groups",
        "\"block\": 6 | \"block\": 4 | a block of 4 participants cannot contain 3 groups",
        "\"blocked\" | \"latin-square\" | a Latin square of 3 groups needs "
            + "blocks of 3, not of 6",
        "\"blocked\" | \"alternating\" | 'alternating' is not one of blocked, latin-square",
        "\"high-low\", | \"low\", | 'low' is not a condition",
        "\"high-low\", | \"high\", | the condition high is named twice",
        "\"KitchenMiddle\" | \"CellarView\" | no Viewpoint with the DEF 'CellarView'",
        "\"recognition.csv\" | \"memory.csv\" | there is no file 'memory.csv'",
        "\"side-by-side\" | \"dome\" | 'dome' is not one of window, side-by-side, dual",
        "\"tracker\": \"intertrax2:auto\" | \"tracker\": \"replay:x.csv\" | a recording cannot be the tracker",
        "\"seconds\": 45 | \"seconds\": \"long\" | \"seconds\" must be a number from "
            + "0.1 to 36000",
        "\"seed\": 2009 | \"seed\": 0.5 | \"seed\" must be a whole number",
        "\"seed\": 2009 | \"mute\": 1 | \"mute\" must be true or false",
        "\"name\": \"lounge\" | \"name\": \"kitchen\" | the area kitchen is named twice",
        "\"order\": \"fixed\" | \"order\": \"any\" | 'any' is not one of fixed, counterbalanced",
        "\"stay\": \"turn\" | \"stay\": \"run\" | 'run' is not one of turn, walk, free",
        "\"closed\": false | \"closed\": 0 | \"closed\" must be true or false",
        "\"seconds\": 45} | \"seconds\": 45, \"within\": \"CellarProx\"} | no ProximitySensor and "
            + "no group with the DEF 'CellarProx'",
        "\"ipd\": 63 | \"operator\": -1 | \"operator\" must be the number of a monitor",
        "\"ipd\": 63 | \"pointer\": \"lost\" | 'lost' is not one of auto, kept, free",
        "\"participants\": 54, | `` | a study needs \"participants\"",
      })
  void whatCannotBeIsAnErrorWithItsPlace(String old, String other, String message)
      throws IOException {
    assertThat(text).contains(old);
    assertThat(problems(text.replace(old, other)))
        .isNotEmpty()
        .allMatch(line -> line.matches("(?s)\\d+:\\d+: .*"))
        .anyMatch(line -> line.contains(message));
  }

  @Test
  void whatIsNoJsonIsAnErrorWithItsPlace() throws IOException {
    assertThat(problems("{\n\"name\": }"))
        .singleElement()
        .asString()
        .matches("(?s)2:\\d+: this is not valid JSON: .*");
    assertThat(problems("")).singleElement().asString().contains("the file is empty");
    assertThat(problems("{\"name\": \"a\", \"name\": \"b\"}"))
        .singleElement()
        .asString()
        .contains("Duplicate field 'name'");
    assertThat(problems("[]")).anyMatch(line -> line.contains("a study must be an object"));
  }

  @Test
  void anotherEncodingIsAnErrorWithTheFilesName() throws IOException {
    for (Charset charset : List.of(StandardCharsets.UTF_16, Charset.forName("windows-1253"))) {
      Files.writeString(file, text.replace("memory", "μνήμη"), charset);
      ProblemCollector problems = new ProblemCollector();
      assertThat(StudyReader.read(file, problems)).isEmpty();
      assertThat(problems.list())
          .singleElement()
          .hasToString(file + ":1:1: the file is not UTF-8 text; the study is not used");
    }
  }

  @Test
  void theQualityOfSessionsMayBeLeftOut() throws IOException {
    assertThat(problems(text.replaceFirst("(?m)^ *\"quality\".*$", ""))).isEmpty();
    assertThat(StudyReader.read(file, new ProblemCollector()).orElseThrow().quality())
        .isEqualTo(QualityCriteria.DEFAULT);
  }

  @Test
  void whatIsAskedOfSessionsIsReadAndFaultsAreNamed() throws IOException {
    String quality =
        "\"quality\": {\"min_fps\": 24, \"exclude\": [\"simulated\", \"tracker-lost\"]},";
    assertThat(problems(text.replaceFirst("\"quality\".*", quality))).isEmpty();
    assertThat(StudyReader.read(file, new ProblemCollector()).orElseThrow().quality())
        .isEqualTo(
            new QualityCriteria(
                OptionalDouble.of(24),
                0.1,
                1,
                Set.of(SessionFlag.TRACKER_LOST, SessionFlag.SIMULATED)));
    assertThat(
            problems(
                text.replaceFirst("\"quality\".*", "\"quality\": {\"exclude\": [\"sleepy\"]},")))
        .singleElement()
        .asString()
        .contains(
            "'sleepy' is not a flag of a session (repeated-exposure, display-fallback, ",
            "the study is not used");
    assertThat(
            problems(
                text.replaceFirst("\"quality\".*", "\"quality\": {\"max_slow_frames\": 0.2},")))
        .singleElement()
        .asString()
        .contains("\"max_slow_frames\" needs \"min_fps\"");
  }

  @Test
  void tooFewFramesAreToldByMeanAndByShare() {
    QualityCriteria quality = new QualityCriteria(OptionalDouble.of(30), 0.1, 1, Set.of());
    assertThat(quality.tooSlow(30, 0.1)).isEmpty();
    assertThat(quality.tooSlow(22.46, 0.1))
        .containsExactly("22.5 frames per second on average, less than 30");
    assertThat(quality.tooSlow(40, 0.123))
        .containsExactly("12.3 % of the frames slower than 30 per second, more than 10 %");
    assertThat(quality.tooSlow(10, 0.9)).hasSize(2);
    assertThat(QualityCriteria.DEFAULT.tooSlow(0.1, 1)).isEmpty();
  }

  @Test
  void thePublishedSchemaHasTheKeysOfTheReader() throws IOException {
    JsonNode schema = new ObjectMapper().readTree(folder.resolve("study.schema.json").toFile());
    assertThat(keys(schema)).isEqualTo(known(text.replaceFirst("\\{", "{\"x\": 1,")));
    JsonNode area = schema.at("/properties/areas/items");
    assertThat(keys(area))
        .isEqualTo(known(text.replace("{\"name\": \"kitchen\",", "{\"x\": 1, \"name\": \"k\",")));
    assertThat(keys(schema.at("/properties/display")))
        .isEqualTo(known(text.replace("{\"mode\"", "{\"x\": 1, \"mode\"")));
    assertThat(keys(schema.at("/properties/quality")))
        .isEqualTo(known(text.replace("\"quality\": {", "\"quality\": {\"x\": 1, ")));
    assertThat(schema.at("/properties/quality/properties/exclude/items/enum"))
        .extracting(JsonNode::asText)
        .containsExactly(
            Arrays.stream(SessionFlag.values()).map(SessionFlag::spelling).toArray(String[]::new));
    assertThat(keys(schema.at("/properties/practice")))
        .isEqualTo(known(text.replace("\"practice\": {", "\"practice\": {\"x\": 1, ")));
    assertThat(keys(schema.at("/properties/questionnaires/items")))
        .isEqualTo(known(text.replace("{\"kind\"", "{\"x\": 1, \"kind\"")));
  }

  private static List<String> keys(JsonNode schema) {
    assertThat(schema.path("additionalProperties").asBoolean(true)).isFalse();
    List<String> keys = new ArrayList<>();
    schema.get("properties").fieldNames().forEachRemaining(keys::add);
    return keys.stream().sorted().toList();
  }

  /** The keys that the reader lists when it meets an unknown one. */
  private List<String> known(String study) throws IOException {
    Matcher listed =
        Pattern.compile("has no \"x\" \\(known keys: ([^)]*)\\)")
            .matcher(String.join("\n", problems(study)));
    assertThat(listed.find()).isTrue();
    return List.of(listed.group(1).split(", "));
  }
}
