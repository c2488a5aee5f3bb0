package org.selectiverenderer.study.questionnaire;

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
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.definition.StudyTemplate;
import org.selectiverenderer.study.questionnaire.paper.PaperQuestionnaireHtml;
import org.selectiverenderer.study.questionnaire.read.ItemListReader;

class QuestionnaireTest {
  @TempDir Path folder;

  private Optional<List<Questionnaire>> items(
      ItemQuestionnaireKind kind, String text, ProblemCollector problems) throws IOException {
    Path file = folder.resolve("items.csv");
    Files.writeString(file, text);
    return ItemListReader.read(kind, file, kind.spelling(), english(), problems);
  }

  private ParticipantMessages english() throws IOException {
    return ParticipantMessages.of("en", folder, new ProblemCollector()).orElseThrow();
  }

  @Test
  void bothStudiesItemsHaveNamesInBothLanguages() throws IOException {
    StudyTemplate.write(folder, Path.of("scenes/apartment.x3d"));
    ProblemCollector problems = new ProblemCollector();
    for (ItemQuestionnaireKind kind : ItemQuestionnaireKind.values()) {
      Path file =
          folder.resolve(
              kind == ItemQuestionnaireKind.RECOGNITION
                  ? "recognition.csv"
                  : "pilot/expectancy.csv");
      for (String language : List.of("en", "el")) {
        ParticipantMessages wording =
            ParticipantMessages.of(language, folder, problems).orElseThrow();
        List<Questionnaire> areas =
            ItemListReader.read(kind, file, kind.spelling(), wording, problems).orElseThrow();
        assertThat(areas)
            .hasSize(kind == ItemQuestionnaireKind.RECOGNITION ? 6 : 7); // And the example.
      }
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void badItemsAreErrorsAtTheirPlaces() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    assertThat(
            items(
                ItemQuestionnaireKind.RECOGNITION,
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
    Questionnaire hall =
        items(ItemQuestionnaireKind.EXPECTANCY, text.toString(), new ProblemCollector())
            .orElseThrow()
            .get(0);
    List<Question> one = hall.ordered(1, "001").questions();
    assertThat(hall.ordered(1, "001").questions()).isEqualTo(one);
    assertThat(hall.ordered(1, "002").questions())
        .containsExactlyInAnyOrderElementsOf(one)
        .isNotEqualTo(one);
    assertThat(hall.ordered(2, "001").questions()).isNotEqualTo(one);
  }

  @Test
  void theOrderOfAParticipantIsThatOfEarlierVersions() throws IOException {
    StringBuilder text = new StringBuilder("area,object,consistency,present,en\n");
    IntStream.range(0, 8).forEach(i -> text.append("hall,o" + i + ",consistent,yes,O" + i + "\n"));
    Questionnaire hall =
        items(ItemQuestionnaireKind.RECOGNITION, text.toString(), new ProblemCollector())
            .orElseThrow()
            .get(0);
    assertThat(hall.ordered(2009, "007").questions())
        .extracting(Question::id)
        .containsExactly("o2", "o6", "o5", "o3", "o4", "o0", "o1", "o7");
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
                ParticipantMessages.class.getResourceAsStream(
                    "messages_" + language + ".properties")),
            StandardCharsets.UTF_8)) {
      words.load(reader);
    }
    return words;
  }

  @Test
  void aTranslationIsAFileBesideTheStudy() throws IOException {
    ProblemCollector problems = new ProblemCollector();
    assertThat(ParticipantMessages.of("fr", folder, problems)).isEmpty();
    assertThat(problems.list()).singleElement().asString().contains("messages_fr.properties");
    Files.writeString(folder.resolve("messages_fr.properties"), "yes = Oui\n");
    ParticipantMessages french = ParticipantMessages.of("fr", folder, problems).orElseThrow();
    assertThat(french.of("yes")).isEqualTo("Oui");
    assertThat(french.of("no")).isEqualTo("No");
  }

  @Test
  void thePageToPrintAsksTheSameAndIsWhole() throws IOException {
    List<Questionnaire> asked =
        items(
                ItemQuestionnaireKind.RECOGNITION,
                "area,object,consistency,present,en\nhall,coat,consistent,yes,Coat & <hat>\n",
                new ProblemCollector())
            .orElseThrow();
    String page = PaperQuestionnaireHtml.html(asked, english(), "001");
    assertThat(page)
        .startsWith("<!DOCTYPE html>")
        .contains(
            "<td>Coat &amp; &lt;hat&gt;</td><td>Yes</td><td>No</td><td>1</td>",
            "<td>5</td></tr>",
            "brief exposure to the hall")
        .doesNotContain("{0}");
  }

  @Test
  void tablesOfGermanAndGreekSpreadsheetsAreRead() throws IOException {
    for (String separator : List.of(";", "\t")) {
      List<Questionnaire> asked =
          items(
                  ItemQuestionnaireKind.RECOGNITION,
                  "\uFEFFarea,object,consistency,present,en\r\nhall,coat,consistent,yes,Coat\r\n"
                      .replace(",", separator),
                  new ProblemCollector())
              .orElseThrow();
      assertThat(asked.get(0).questions()).extracting(Question::text).containsExactly("Coat");
    }
  }
}
