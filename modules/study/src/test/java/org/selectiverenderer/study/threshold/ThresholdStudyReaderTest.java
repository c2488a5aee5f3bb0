package org.selectiverenderer.study.threshold;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.study.definition.StudyTemplate;

/** Settings are read whole or not at all. */
class ThresholdStudyReaderTest extends ThresholdPilotFixture {
  @Test
  void theTemplatesSettingsAreReadAndNameObjectsOfTheScene() throws IOException {
    StudyTemplate.write(folder.resolve("new"), Path.of("scenes/apartment.x3d"));

    ThresholdStudy study =
        ThresholdStudyReader.read(folder.resolve("new/pilot/threshold.json"), problems)
            .orElseThrow();

    assertThat(problems.list()).isEmpty();
    assertThat(study.scene()).isEqualTo(Path.of("scenes/apartment.x3d").toAbsolutePath());
    String scene = Files.readString(study.scene());
    assertThat(study.objects())
        .hasSize(6)
        .allSatisfy(judged -> assertThat(scene).contains("DEF='" + judged.object() + "'"));
    assertThat(study.rule()).isEqualTo(new StaircaseRule(2, 8, 2, 60));
    assertThat(study.folder()).isEqualTo(folder.resolve("new/pilot/threshold"));
  }

  @Test
  void whatIsLeftOutHasTheTemplatesValues() throws IOException {
    ThresholdStudy study = study();

    assertThat(study.task()).isEqualTo(ThresholdTask.TELL_APART);
    assertThat(study.rungs()).isEqualTo(12);
    assertThat(study.picture()).isEqualTo(360);
    assertThat(study.views()).hasSize(2);
    assertThat(study.objects().get(0).name()).isEqualTo("Vase");
    assertThat(study.objects().get(4).name()).isEqualTo("a book");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "\"seed\": 7     | \"rung\": 7          | did you mean \"rungs\"?",
        "tell-apart      | look                 | 'look' is not one of tell-apart, recognise",
        "room.x3d        | hall.x3d             | there is no file 'hall.x3d'",
        "\"seed\": 7     | \"reversals\": 7     | must be an even number, at least 2, but",
        "\"seed\": 7     | \"fewest\": 2        | \"fewest\" must be a number from",
        "\"seed\": 7     | \"allow\": [\"no\"]   | there is no folder 'no' relative to this file",
        "\"Mug\"         | \"Vase\"             | the object Vase is named twice",
        "\"name\": \"Pilot\", | ~~             | a threshold pilot needs \"name\""
      })
  void whatCannotBeIsAnErrorWithItsPlace(String before, String after, String message)
      throws IOException {
    Files.writeString(file, Files.readString(file).replace(before, after));

    assertThat(ThresholdStudyReader.read(file, problems)).isEmpty();
    assertThat(told())
        .singleElement()
        .asString()
        .contains("threshold.json:", message, "he pilot is not used");
  }

  @Test
  void threeObjectsAreTooFewToChooseAmongFourNames() throws IOException {
    Files.writeString(
        file,
        """
        {"name": "P", "scene": "room.x3d", "task": "recognise",
         "objects": [{"object": "A"}, {"object": "B"}, {"object": "C"}]}
        """);
    assertThat(ThresholdStudyReader.read(file, problems)).isEmpty();
    assertThat(told()).singleElement().asString().contains("needs at least four");
  }
}
