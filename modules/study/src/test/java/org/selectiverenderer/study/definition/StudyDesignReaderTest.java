package org.selectiverenderer.study.definition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialSettings;

class StudyDesignReaderTest {
  private static final String STUDY =
      """
      {"name": "S", "scene": "room.x3d", "participants": 8, "seed": 1,
       "factors": [
        {"name": "quality", "varies": "within", "levels": [
         {"name": "full", "condition": "high"},
         {"name": "low", "table": {"file": "choices.csv", "column": "low"}}]},
        {"name": "light", "varies": "between", "levels": [
         {"name": "day", "light": "on"}, {"name": "night", "light": "off"}]}],
       "blocks": [
        {"name": "main", "stimuli": "list.csv", "order": "random",
         "at_most_in_a_row": {"quality": 2}, "viewpoint": "Door",
         "trial": [
          {"show": "instruction", "text": {"en": "Item {item}", "el": "{item}"}},
          {"show": "exposure", "seconds": 0.5, "choices": {"{object}": 1},
           "keys": ["f", "j"], "correct": "{answer}"}]}],
       "questionnaires": []}
      """;

  @TempDir private Path folder;

  @BeforeEach
  void files() throws IOException {
    Files.writeString(
        folder.resolve("room.x3d"),
        "<X3D><Scene><Viewpoint DEF='Door'/><Switch DEF='Vase'/><Switch DEF='Lamp'/></Scene></X3D>");
    Files.writeString(folder.resolve("choices.csv"), "switch,low\nVase,1\nLamp,\n");
    Files.writeString(
        folder.resolve("list.csv"), "item,object,answer\n1,Vase,f\n2,Lamp,j\n3,Vase,f\n");
  }

  private Optional<Study> read(String text, ProblemCollector problems) throws IOException {
    Path file = folder.resolve("study.json");
    Files.writeString(file, text);
    return StudyReader.read(file, problems);
  }

  @Test
  void theWayInWhichVersionsChangeIsOfTheStudyOrOfALevel() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String text =
        STUDY
            .replaceFirst("\\{", "{\"switch\": \"fade:500\", ")
            .replace("\"light\": \"off\"", "\"light\": \"off\", \"switch\": \"unseen\"");
    Study study = read(text, problems).orElseThrow(() -> new AssertionError(problems.list()));
    assertThat(study.transition()).isEqualTo(new SwitchTransition.Fade(500));
    assertThat(study.design().groups().get(0).settings().transition()).isEmpty();
    assertThat(study.design().groups().get(1).settings().transition())
        .contains(new SwitchTransition.Unseen(SwitchTransition.TURN));
    assertThat(read(STUDY, problems).orElseThrow().transition())
        .isEqualTo(SwitchTransition.AT_ONCE);
  }

  @Test
  void qualitiesAreOfTheStudyABlockOrALevelEachByItself() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String text =
        STUDY
            .replaceFirst("\\{", "{\"qualities\": {\"textures\": \"low\", \"light\": \"high\"}, ")
            .replace("\"viewpoint\": \"Door\"", "\"qualities\": {\"shading\": \"low\"}")
            .replace(
                "\"full\", \"condition\": \"high\"",
                "\"full\", \"qualities\": {\"light\": \"selective\", \"shading\": \"high\"}");
    Study study = read(text, problems).orElseThrow(() -> new AssertionError(problems.list()));
    assertThat(study.qualities())
        .isEqualTo(Map.of(Quality.TEXTURES, QualityRule.LOW, Quality.LIGHT, QualityRule.HIGH));
    TrialBlock block = study.design().blocks().get(0);
    TrialSettings full = block.factors().get(0).levels().get(0).settings();
    assertThat(study.qualities(full.over(block.settings())))
        .isEqualTo(
            Map.of(
                Quality.TEXTURES,
                QualityRule.LOW,
                Quality.LIGHT,
                QualityRule.SELECTIVE,
                Quality.SHADING,
                QualityRule.HIGH));
    assertThat(study.qualities(block.settings()))
        .containsEntry(Quality.SHADING, QualityRule.LOW)
        .containsEntry(Quality.LIGHT, QualityRule.HIGH);
  }

  @ParameterizedTest
  @ValueSource(strings = {"{\"colour\": \"low\"}", "{\"light\": \"dim\"}", "\"low\""})
  void anotherQualityOrLevelIsAFaultWithItsPlace(String qualities) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String text = STUDY.replaceFirst("\\{", "{\"qualities\": " + qualities + ", ");
    assertThat(read(text, problems)).isEmpty();
    assertThat(problems.list())
        .first()
        .satisfies(problem -> assertThat(problem.location().line()).isEqualTo(1));
  }

  @ParameterizedTest
  @ValueSource(strings = {"fade", "fade:0", "fade:20000", "unseen:-1", "fade:1e3", "later"})
  void anotherWayIsAFaultWithItsPlace(String spelling) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String text = STUDY.replaceFirst("\\{", "{\"switch\": \"" + spelling + "\", ");
    assertThat(read(text, problems)).isEmpty();
    assertThat(problems.list())
        .singleElement()
        .asString()
        .contains("study.json:", spelling, "at-once, fade:MS or unseen");
  }

  @Test
  void aStudyHasFactorsGroupsAndBlocks() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    Study study = read(STUDY, problems).orElseThrow(() -> new AssertionError(problems.list()));
    assertThat(study.design().groups())
        .extracting(StudyGroup::name)
        .containsExactly("day", "night");
    TrialBlock block = study.design().blocks().get(0);
    assertThat(block.factors()).singleElement().extracting("name").isEqualTo("quality");
    assertThat(block.factors().get(0).levels().get(0).settings().condition())
        .contains(Condition.HIGH);
    assertThat(block.factors().get(0).levels().get(1).settings().choices())
        .containsOnlyKeys("Vase");
    assertThat(block.phases()).hasSize(2);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          "varies": "within" | "varies": "often" | 'often' is not one of between, within
          {"name": "low" | {"name": "full" | the level full is defined twice
          "quality": 2 | "qualty": 2 | 'qualty' is neither a factor of the block nor a column of its stimuli; did you mean 'quality'?
          "order": "random" | "order": "fixed" | "at_most_in_a_row" needs "order": "random"
          Item {item} | Item {itm} | {itm} is neither a factor nor a column of the block's stimuli; did you mean {item}?
          "keys": ["f", "j"] | "keys": ["F1"] | 'F1' is no key; known are letters in lower case
          "correct": "{answer}" | "correct": "x" | 'x' is none of the "keys"
          "show": "exposure" | "show": "expose" | there is no phase 'expose'; did you mean 'exposure'?
          "viewpoint": "Door" | "viewpoint": "Dor" | the scene room.x3d has no Viewpoint with the DEF 'Dor', which the block main needs
          "viewpoint": "Door" | "area": "hall" | a trial of the block main is in the area hall, which the study's "areas" do not have
          "column": "low" | "column": "none" | the header lacks none
          "seed": 1 | "seed": 1, "conditions": ["high"] | a study has "conditions" or "factors"
          "stimuli": "list.csv" | "stimuli": "other.csv" | there is no file 'other.csv' relative to the study file
          "at_most_in_a_row": {"quality": 2} | "at_most_in_a_row": {"object": 1, "answer": 1} | no order of the trials of the block main keeps "at_most_in_a_row"
          """)
  void whatCannotBeIsAnError(String before, String after, String message) throws IOException {
    assertThat(STUDY).contains(before);
    ProblemCollector problems = new ProblemCollector();
    assertThat(read(STUDY.replace(before, after), problems)).isEmpty();
    assertThat(problems.list())
        .as(problems.list().toString())
        .anyMatch(problem -> problem.toString().contains(message) && problem.location().line() > 0);
  }

  @Test
  void anExposureThatNothingEndsIsAnError() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    String endless =
        STUDY
            .replace("\"seconds\": 0.5, ", "")
            .replace("\"keys\": [\"f\", \"j\"], \"correct\": \"{answer}\"", "\"until\": \"time\"");
    assertThat(read(endless, problems)).isEmpty();
    assertThat(problems.list())
        .anyMatch(p -> p.toString().contains("an exposure of the block main never ends"));
  }

  @Test
  void moreGroupsThanAStudyCanHaveAreAnError() throws IOException {
    StringBuilder factors = new StringBuilder();
    for (int i = 0; i < 25; i++) {
      factors.append(
          "{\"name\": \"f%d\", \"varies\": \"between\", \"levels\": [{\"name\": \"a\"}, {\"name\": \"b\"}]},"
              .formatted(i));
    }
    ProblemCollector problems = new ProblemCollector();
    assertThat(read(STUDY.replace("\"factors\": [", "\"factors\": [" + factors), problems))
        .isEmpty();
    assertThat(problems.list())
        .anyMatch(
            p ->
                p.toString()
                    .contains("the levels between participants make more than 1000 groups"));
  }

  @Test
  void aSwitchThatTheSceneLacksIsAnError() throws IOException {
    Files.writeString(
        folder.resolve("list.csv"), "item,object,answer\n1,Vase,f\n2,Lmp,j\n3,Vase,f\n");
    ProblemCollector problems = new ProblemCollector();
    assertThat(read(STUDY, problems)).isEmpty();
    assertThat(problems.list())
        .anyMatch(p -> p.toString().contains("no Switch with the DEF 'Lmp'"));
  }

  @Test
  void aFactorIsNotNamedAsAColumnOfTheTableOfTrials() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    assertThat(read(STUDY.replace("\"name\": \"light\"", "\"name\": \"trial\""), problems))
        .isEmpty();
    assertThat(problems.list().get(0).toString())
        .contains("study.json:6:")
        .contains("the factor trial cannot be told from a column of the table of trials");
  }
}
