package org.selectiverenderer.experiment.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.experiment.study.QuestionKind;
import org.selectiverenderer.experiment.study.Study;
import org.selectiverenderer.experiment.study.StudyReader;
import org.selectiverenderer.experiment.study.StudyTemplate;

class QuestionnaireTest {
  @TempDir Path folder;

  private Optional<List<QuestionItem>> items(QuestionKind kind, String text, Problems problems)
      throws IOException {
    Path file = folder.resolve("items.csv");
    Files.writeString(file, text);
    return ItemsReader.read(new Study.Questionnaire(kind, file), "en", problems);
  }

  @Test
  void bothStudiesItemsHaveNamesInBothLanguages() throws IOException {
    Path file = StudyTemplate.write(folder, Path.of("scenes/apartment.x3d"));
    Problems problems = new Problems();
    for (Path each : List.of(file, folder.resolve("pilot/study.json"))) {
      Study study = StudyReader.read(each, problems).orElseThrow();
      for (String language : List.of("en", "el")) {
        List<QuestionItem> items =
            ItemsReader.read(study.questionnaires().get(0), language, problems).orElseThrow();
        assertThat(Screen.areas(items))
            .contains("kitchen", "lounge", "office", "sofa", "desk", "bookcase");
      }
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void badItemsAreErrorsAtTheirPlaces() throws IOException {
    Problems problems = new Problems();
    assertThat(
            items(
                QuestionKind.RECOGNITION,
                """
                area,object,consistency,present,en
                hall,coat,usual,yes,Coat
                hall,boat,consistent,perhaps,Boat
                hall,coat,consistent,yes,
                """,
                problems))
        .isEmpty();
    assertThat(problems.list())
        .extracting(problem -> problem.location().line() + ":" + problem.location().column())
        .containsExactly("2:11", "3:22", "4:26", "4:6");
    assertThat(problems.list())
        .extracting(Problem::message)
        .anyMatch(
            line -> line.contains("coat is listed a second time for hall; line 2 has it already"));
  }

  @Test
  void eachParticipantHasAnOrderOfHisOwnThatStays() throws IOException {
    StringBuilder text = new StringBuilder("area,schema,object,en\n");
    IntStream.range(0, 12).forEach(i -> text.append("hall,HallSchema,o" + i + ",O" + i + "\n"));
    List<QuestionItem> items =
        items(QuestionKind.EXPECTANCY, text.toString(), new Problems()).orElseThrow();
    Screen one = Screen.of(QuestionKind.EXPECTANCY, "hall", items, 1, "001");
    assertThat(Screen.of(QuestionKind.EXPECTANCY, "hall", items, 1, "001")).isEqualTo(one);
    assertThat(Screen.of(QuestionKind.EXPECTANCY, "hall", items, 1, "002").items())
        .containsExactlyInAnyOrderElementsOf(items)
        .isNotEqualTo(one.items());
    assertThat(Screen.of(QuestionKind.EXPECTANCY, "hall", items, 2, "001").items())
        .isNotEqualTo(one.items());
  }

  @Test
  void englishAndGreekHaveTheSameWords() throws IOException {
    assertThat(words("el").keySet()).isEqualTo(words("en").keySet());
  }

  private static Properties words(String language) throws IOException {
    Properties words = new Properties();
    try (Reader reader =
        new InputStreamReader(
            Objects.requireNonNull(
                Wording.class.getResourceAsStream("messages_" + language + ".properties")),
            StandardCharsets.UTF_8)) {
      words.load(reader);
    }
    return words;
  }

  @Test
  void aTranslationIsAFileBesideTheStudy() throws IOException {
    Problems problems = new Problems();
    assertThat(Wording.of("fr", folder, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("messages_fr.properties");
    Files.writeString(folder.resolve("messages_fr.properties"), "yes = Oui\n");
    Wording french = Wording.of("fr", folder, problems).orElseThrow();
    assertThat(french.of("yes")).isEqualTo("Oui");
    assertThat(french.of("no")).isEqualTo("No");
  }

  @Test
  void thePageToPrintAsksTheSameAndIsWhole() throws IOException {
    List<QuestionItem> items =
        items(
                QuestionKind.RECOGNITION,
                "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat & <hat>\n",
                new Problems())
            .orElseThrow();
    Screen screen = Screen.of(QuestionKind.RECOGNITION, "hall", items, 1, "001");
    String page =
        PaperPage.html(
            List.of(screen), Wording.of("en", folder, new Problems()).orElseThrow(), "001");
    assertThat(page)
        .startsWith("<!DOCTYPE html>")
        .contains(
            "<td>Coat &amp; &lt;hat&gt;</td><td>Yes</td><td>No</td><td>1</td>",
            "<td>5</td></tr>",
            "brief exposure to the hall")
        .doesNotContain("{0}");
  }
}
